"""One value of Θ: routes, how one is chosen, and precision raised until the asked accuracy is reached."""
