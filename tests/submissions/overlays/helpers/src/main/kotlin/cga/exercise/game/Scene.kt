package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {

    companion object {
        private const val MOUSE_SENSITIVITY = 0.002f
        private const val SPEED = 6.0f
        private const val TURN_SPEED = 1.2f
        private val GROUND_COLOR = Vector3f(0.0f, 1.0f, 0.0f)
    }

    private val staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera: TronCamera
    private val pointLights = ArrayList<PointLight>()
    private val spotLight: SpotLight

    private var lastX = 0.0
    private var firstMouse = true

    init {
        setupOpenGl()

        ground = createGround()
        ground.emissionColor = GROUND_COLOR

        val model = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        motorcycle = requireNotNull(model) { "Could not load model" }
        motorcycle.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))

        camera = TronCamera()
        camera.parent = motorcycle
        camera.translateLocal(Vector3f(0.0f, 2.5f, 4.5f))
        camera.rotateLocal(toRadians(-30.0f), 0.0f, 0.0f)

        // light 0 belongs to the motorcycle
        val motorcycleLight = PointLight(Vector3f(0.0f, 1.6f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        motorcycleLight.parent = motorcycle
        pointLights.add(motorcycleLight)

        pointLights.add(PointLight(Vector3f(18.0f, 1.5f, 18.0f), Vector3f(10.0f, 0.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(-18.0f, 1.5f, 18.0f), Vector3f(0.0f, 10.0f, 0.0f)))
        pointLights.add(PointLight(Vector3f(18.0f, 1.5f, -18.0f), Vector3f(0.0f, 0.0f, 10.0f)))
        pointLights.add(PointLight(Vector3f(-18.0f, 1.5f, -18.0f), Vector3f(10.0f, 0.0f, 10.0f)))
        pointLights.add(PointLight(Vector3f(4.0f, 1.0f, -9.0f), Vector3f(0.0f, 3.0f, 4.0f)))

        spotLight = SpotLight(Vector3f(0.0f, 1.0f, -1.9f), Vector3f(4.0f, 4.0f, 4.0f), toRadians(12.5f), toRadians(20.0f))
        spotLight.rotateLocal(toRadians(-9.0f), 0.0f, 0.0f)
        spotLight.parent = motorcycle
    }

    private fun setupOpenGl() {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
        GLError.checkThrow()
    }

    private fun createTexture(path: String): Texture2D {
        return Texture2D(path, true).apply { setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR) }
    }

    private fun createGround(): Renderable {
        val diffuse = createTexture("assets/textures/ground_diff.png")
        val emission = createTexture("assets/textures/ground_emit.png")
        val specular = createTexture("assets/textures/ground_spec.png")
        val material = Material(diffuse, emission, specular, 60.0f, Vector2f(64.0f))
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes = arrayOf(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        return Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, attributes, material)))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        // rainbow
        val rainbow = Vector3f(sin(2.0f * t), sin(0.7f * t), sin(1.3f * t)).mul(0.5f).add(0.5f, 0.5f, 0.5f)
        motorcycle.emissionColor = rainbow
        pointLights[0].color = rainbow

        // be sure to activate the shader before setting uniforms
        staticShader.use()
        camera.bind(staticShader)
        for (i in pointLights.indices) {
            pointLights[i].bind(staticShader, "pointLights[$i]")
        }
        spotLight.bind(staticShader, "spotLight", camera.getCalculateViewMatrix())

        ground.render(staticShader)
        motorcycle.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        var direction = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) direction = 1.0f
        if (window.getKeyState(GLFW_KEY_S)) direction = -1.0f
        if (direction == 0.0f) return

        motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -direction * SPEED * dt))
        if (window.getKeyState(GLFW_KEY_A)) motorcycle.rotateLocal(0.0f, direction * TURN_SPEED * dt, 0.0f)
        if (window.getKeyState(GLFW_KEY_D)) motorcycle.rotateLocal(0.0f, -direction * TURN_SPEED * dt, 0.0f)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
            return
        }
        val xOffset = (xpos - lastX).toFloat() * MOUSE_SENSITIVITY
        lastX = xpos
        camera.rotateAroundPoint(0.0f, -xOffset, 0.0f, Vector3f())
    }

    fun cleanup() {
        ground.cleanup()
        motorcycle.cleanup()
        staticShader.cleanup()
    }
}
