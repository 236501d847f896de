package cga.framework

/** Whether there is a desktop to open windows on. */
public object Display {
    /** On Linux one of the two environment variables names it; Windows and macOS always have one. */
    public val isPresent: Boolean =
        !System.getProperty("os.name").startsWith("Linux") ||
            listOf("DISPLAY", "WAYLAND_DISPLAY").any { !System.getenv(it).isNullOrEmpty() }
}
