"""Hard cases stay stable: a catalogue over all parts of the library, with what double precision says beside it."""
