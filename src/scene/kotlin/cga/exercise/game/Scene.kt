package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.ModelLoader
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.shader.ShaderProgram
import cga.framework.Frame
import cga.framework.SpecularModel
import cga.framework.WindowState
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Matrix4fc
import org.joml.Vector3f
import org.joml.Vector3fc
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL33C.*
import kotlin.math.abs
import kotlin.math.sin

/** Makes the programs of a scene, as [ShaderProgram]'s constructor does. */
public typealias NewProgram = (vertexPath: String, fragmentPath: String, constants: Map<String, Int>) -> ShaderProgram

/**
 * The motorcycle on its glowing grid: everything that the sheet asks for, one [Step] at a time.
 *
 * Made without an OpenGL context; what it draws with is uploaded by the first [render]. Time and input only ever come in as arguments.
 * Throws [cga.framework.InputError] when a model, texture or shader cannot be read.
 */
public class Scene(
    private val window: WindowState,
    step: Step,
    newProgram: NewProgram,
) {
    public constructor(window: WindowState, step: Step = Step.FINAL) : this(window, step, ::ShaderProgram)

    public val ground: Renderable =
        ModelLoader.loadModel("assets/ground/ground.obj").apply { meshes.forEach { it.material?.tcMultiplier?.set(64f) } }
    public val motorcycle: Renderable = ModelLoader.loadModel("assets/motorcycle/motorcycle.obj")
    public val camera: TronCamera = TronCamera(parent = motorcycle)
    public val lights: SceneLights = SceneLights(motorcycle)

    // One program for each number of lights that steps have: a light that is off costs nothing, not even an interpolated vector.
    private val programs =
        Step.entries
            .map(lights::count)
            .distinct()
            .associateWith { newProgram(VERTEX_SHADER, FRAGMENT_SHADER, it) }
    private var program = programs.getValue(lights.count(step))
    public val ride: Ride = Ride()
    public val orbit: Orbit = Orbit()
    public var time: Double = 0.0
        private set

    private val view = Matrix4d()
    private val matrix = Matrix4f()
    private val motorcycleTint = Vector3f()

    /** Held in place of the colour that the step has, by whoever looks closer; null for none. */
    public var motorcycleColor: Vector3fc? = null

    /** Where the camera is, in the motorcycle's space, instead of where the orbit puts it; null for the orbit's place. */
    public var cameraPlace: Matrix4fc? = null

    /** Which part of the sheet is shown; setting it also chooses the step's [specularModel]. */
    public var step: Step = step
        set(value) {
            field = value
            specularModel = value.specularModel
            lights.switchTo(value)
            program = programs.getValue(lights.count(value))
        }

    /** Phong or Blinn-Phong. */
    public var specularModel: SpecularModel = step.specularModel

    /** L_a, linear RGB, finite and not negative. */
    public var ambient: Vector3fc = Vector3f()
        set(value) {
            require(value.isFinite && minOf(value.x(), value.y(), value.z()) >= 0f) { "ambient $value must be finite and not negative" }
            field = Vector3f(value)
        }

    /** 1 for none, as the sheet wants it; 2.2 encodes the colours for the usual screen. Finite, and so is 1/gamma. */
    public var gamma: Float = 1f
        set(value) {
            require(value > 0f && value.isFinite() && (1f / value).isFinite()) { "gamma $value and 1/gamma must be finite and positive" }
            field = value
        }

    init {
        lights.switchTo(step)
    }

    /** Draws the scene into the framebuffer that is bound. */
    public fun render() {
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)
        glDisable(GL_DITHER)
        glClearColor(0f, 0f, 0f, 1f)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        prepare()
        // The program first, since uniforms are set on the one in use; then what all draws share; then the draws.
        program.use()
        camera.bind(program)
        // solution 4.2.2: bind the lights
        lights.bind(program, view)
        // end of solution
        program.setUniform("ambient", ambient)
        // solution 4.7: tell the shader whether the specular model is Blinn-Phong
        program.setUniform("blinnPhong", specularModel == SpecularModel.BLINN_PHONG)
        // end of solution
        program.setUniform("inverseGamma", 1f / gamma)
        // solution 4.4: send the colour of the ground
        program.setUniform("emissiveTint", groundTint())
        // end of solution
        ground.render(program, view)
        // solution 4.4: send the colour of the motorcycle by the same uniform
        program.setUniform("emissiveTint", motorcycleTint)
        // end of solution
        motorcycle.render(program, view)
    }

    /** Advances by [dt] seconds to time [t]; the keys held down drive. The course's form: a Float holds t to 1 ms up to 2.3 hours. */
    public fun update(
        dt: Float,
        t: Float,
    ): Unit = update(dt.toDouble(), t.toDouble())

    /** Advances by [dt] seconds to time [t]; the keys held down drive. */
    public fun update(
        dt: Double,
        t: Double,
    ) {
        time = t
        ride.update(window, dt)
    }

    /** The number keys 1 to 8 choose the step, B switches between Phong and Blinn-Phong. */
    public fun onKey(
        key: Int,
        @Suppress("UNUSED_PARAMETER") scancode: Int,
        action: Int,
        @Suppress("UNUSED_PARAMETER") mode: Int,
    ) {
        if (action != GLFW_PRESS) return
        if (key in GLFW_KEY_1..GLFW_KEY_8) step = Step.entries[key - GLFW_KEY_1]
        if (key == GLFW_KEY_B) {
            specularModel = if (specularModel == SpecularModel.PHONG) SpecularModel.BLINN_PHONG else SpecularModel.PHONG
        }
    }

    /** The mouse moved to ([xpos], [ypos]) pixels: the camera turns about the motorcycle, 0.002 rad a pixel in x. */
    public fun onMouseMove(
        xpos: Double,
        @Suppress("UNUSED_PARAMETER") ypos: Double,
    ) {
        orbit.onMouseMove(xpos, step.turnsWithMouse)
    }

    /** Compiles the shaders as they are on disk now; see [ShaderProgram.reload]. */
    public fun reloadShaders() {
        programs.values.forEach(ShaderProgram::reload)
    }

    /** The picture that [render] would draw now, as plain data. */
    public fun frame(): Frame {
        prepare()
        return Frame(
            view = Matrix4d(view),
            projection = camera.getCalculateProjectionMatrix(),
            ambient = Vector3f(ambient),
            specularModel = specularModel,
            gamma = gamma,
            lights = lights.shining.map { it.toFrameLight() },
            draws = ground.toFrameDraws(groundTint()) + motorcycle.toFrameDraws(motorcycleTint),
        )
    }

    /** Frees everything on the GPU. */
    public fun cleanup() {
        programs.values.forEach(ShaderProgram::cleanup)
        ground.cleanup()
        motorcycle.cleanup()
    }

    /** Brings matrices and colours up to the present time and input. */
    private fun prepare() {
        motorcycle.setLocalModelMatrix(ride.place(matrix))
        camera.setLocalModelMatrix(cameraPlace ?: orbit.place(step.turnsWithMouse, matrix))
        camera.aspect = window.framebufferWidth.toFloat() / window.framebufferHeight
        camera.calculateViewMatrix(view)
        // solution 4.4: give the motorcycle and its light a colour that changes with the time, where the step has colour
        // instead: motorcycleTint.set(1f)
        if (step.color) colorAt(time, motorcycleTint) else motorcycleTint.set(1f)
        lights.setMotorcycleColor(motorcycleTint)
        // end of solution
        motorcycleColor?.let { lights.setMotorcycleColor(motorcycleTint.set(it)) }
    }

    // solution 4.4: the colour of the ground, where the step has colour
    // instead: private fun groundTint(): Vector3fc = WHITE
    private fun groundTint(): Vector3fc = if (step.color) GREEN else WHITE
    // end of solution

    public companion object {
        public const val VERTEX_SHADER: String = "shaders/scene.vert"
        public const val FRAGMENT_SHADER: String = "shaders/scene.frag"
        private val WHITE: Vector3fc = Vector3f(1f)

        // solution
        private val GREEN: Vector3fc = Vector3f(0f, 1f, 0f)
        // end of solution

        // solution

        /** The motorcycle's colour: |sin| of t, t/2 and t/3, so that no channel is ever negative. */
        private fun colorAt(
            t: Double,
            dest: Vector3f,
        ): Vector3f = dest.set(abs(sin(t)).toFloat(), abs(sin(t / 2)).toFloat(), abs(sin(t / 3)).toFloat())
        // end of solution
    }
}
