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
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import java.util.TreeMap
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private lateinit var m_shader: ShaderProgram
    private lateinit var m_ground: Renderable
    private lateinit var m_bike: Renderable
    private lateinit var m_camera: TronCamera

    // sorted by name, the place in this order is the index in the shader
    private val m_lights: TreeMap<String, PointLight> = TreeMap<String, PointLight>()

    // the camera's place on a sphere about the motorcycle
    private var m_theta: Float = 0.0f
    private var m_phi: Float = Math.toRadians(32.0).toFloat()
    private val m_radius: Float = 5.0f

    private var m_lastMouseX: Double = 0.0
    private var m_mouseInitialized: Boolean = false

    init {
        initOpenGL()
        initObjects()
        initLights()
        initCamera()
    }

    private fun initOpenGL() {
        m_shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)
    }

    private fun initObjects() {
        val objMesh = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attributes: Array<VertexAttribute> = arrayOf<VertexAttribute>(
            VertexAttribute(3, 32, 0),
            VertexAttribute(2, 32, 12),
            VertexAttribute(3, 32, 20)
        )
        val material: Material = Material(
            loadTexture("diff"),
            loadTexture("emit"),
            loadTexture("spec"),
            60.0f,
            Vector2f(64.0f, 64.0f)
        )
        m_ground = Renderable()
        m_ground.meshes.add(Mesh(objMesh.vertexData, objMesh.indexData, attributes, material))

        val model: Renderable? = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
        if (model == null) {
            throw RuntimeException("could not load the motorcycle")
        }
        m_bike = model
        m_bike.scaleLocal(Vector3f(0.8f, 0.8f, 0.8f))
    }

    private fun loadTexture(kind: String): Texture2D {
        val texture: Texture2D = Texture2D("assets/textures/ground_" + kind + ".png", true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    private fun initLights() {
        val bikeLight: PointLight = PointLight(Vector3f(0.0f, 1.7f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        bikeLight.parent = m_bike
        m_lights.put("bike", bikeLight)

        val headlight: SpotLight = SpotLight(Vector3f(0.0f, 0.9f, -1.8f), Vector3f(3.0f, 2.8f, 2.2f), 13.0f, 27.0f)
        headlight.rotateLocal(Math.toRadians(-9.0).toFloat(), 0.0f, 0.0f)
        headlight.parent = m_bike
        m_lights.put("headlight", headlight)

        val names: Array<String> = arrayOf<String>("cornerA", "cornerB", "cornerC", "cornerD")
        for (i in 0 until names.size) {
            val x: Float = if (i % 2 == 0) -14.0f else 14.0f
            val z: Float = if (i / 2 == 0) -14.0f else 14.0f
            val rgb: Vector3f = hsvToRgb(i * 90.0f + 20.0f, 0.9f, 1.0f)
            m_lights.put(names[i], PointLight(Vector3f(x, 1.8f, z), rgb.mul(7.0f)))
        }
    }

    private fun initCamera() {
        m_camera = TronCamera()
        m_camera.parent = m_bike
        updateCamera()
    }

    /** Spherical angles to a point, seen from the motorcycle. */
    private fun updateCamera() {
        val target: Vector3f = Vector3f(0.0f, 0.6f, 0.0f)
        val eye: Vector3f = Vector3f(
            m_radius * cos(m_phi) * sin(m_theta),
            m_radius * sin(m_phi),
            m_radius * cos(m_phi) * cos(m_theta)
        )
        m_camera.setTarget(target)
        m_camera.setEye(eye.add(target))
    }

    /** hue in degrees, saturation and value from 0 to 1 */
    private fun hsvToRgb(hue: Float, saturation: Float, value: Float): Vector3f {
        val h: Float = (hue % 360.0f) / 60.0f
        val sector: Int = h.toInt()
        val f: Float = h - sector
        val p: Float = value * (1.0f - saturation)
        val q: Float = value * (1.0f - saturation * f)
        val t: Float = value * (1.0f - saturation * (1.0f - f))
        when (sector) {
            0 -> return Vector3f(value, t, p)
            1 -> return Vector3f(q, value, p)
            2 -> return Vector3f(p, value, t)
            3 -> return Vector3f(p, q, value)
            4 -> return Vector3f(t, p, value)
            else -> return Vector3f(value, p, q)
        }
    }

    private fun bindLights() {
        val view: Matrix4f = m_camera.getCalculateViewMatrix()
        var index: Int = 0
        for (entry in m_lights.entries) {
            val light: PointLight = entry.value
            if (light is SpotLight) {
                light.bind(m_shader, "[" + index + "]", view)
                m_shader.setUniform("uSpotIndex", index)
            } else {
                light.bind(m_shader, "[" + index + "]")
            }
            index++
        }
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        val bikeColor: Vector3f = hsvToRgb(45.0f * t, 0.75f, 1.0f)
        m_lights.get("bike")!!.setColor(bikeColor)

        m_shader.use()
        m_camera.bind(m_shader)
        bindLights()

        m_shader.setUniform("uEmissionColor", Vector3f(0.0f, 1.0f, 0.0f))
        m_ground.render(m_shader)
        m_shader.setUniform("uEmissionColor", bikeColor)
        m_bike.render(m_shader)
    }

    fun update(dt: Float, t: Float) {
        var direction: Float = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) {
            direction = -1.0f
        } else if (window.getKeyState(GLFW_KEY_S)) {
            direction = 1.0f
        }
        if (direction != 0.0f) {
            m_bike.translateLocal(Vector3f(0.0f, 0.0f, direction * 7.0f * dt))
            var steering: Float = 0.0f
            if (window.getKeyState(GLFW_KEY_A)) steering += 1.2f
            if (window.getKeyState(GLFW_KEY_D)) steering -= 1.2f
            m_bike.rotateLocal(0.0f, -direction * steering * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (m_mouseInitialized) {
            val deltaX: Double = xpos - m_lastMouseX
            m_theta -= (deltaX * 0.002).toFloat()
            updateCamera()
        }
        m_lastMouseX = xpos
        m_mouseInitialized = true
    }

    fun cleanup() {
        m_ground.cleanup()
        m_bike.cleanup()
        m_shader.cleanup()
    }
}
