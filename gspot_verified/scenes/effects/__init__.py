"""The effects a scene may call for: each brings its states, parameters, equations and events."""
