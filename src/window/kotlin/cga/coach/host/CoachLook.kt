package cga.coach.host

/** What a key or a button wants done before the next picture. */
internal enum class Wish { RELOAD, RESTART, SCREENSHOT, CLOSE }

/** What of the window is open, and what is wanted of it. */
internal class CoachLook {
    var isOpen: Boolean = false
    var showsKeys: Boolean = false
    var isPaused: Boolean = false
    private var wish: Wish? = null

    fun want(wish: Wish) {
        this.wish = wish
    }

    /** What is wanted, once. */
    fun take(): Wish? = wish.also { wish = null }
}
