package cga.grading.capture

import java.io.IOException

/** A capture file is damaged, faked or beyond the limits; the message says in what. */
public class BadCapture(message: String) : IOException(message)
