using System.Numerics;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// The shadows of sun and moon, and how much of the sky a place sees. The static world is drawn only when the sun or the camera has moved
/// on, and only where the picture shows places that it may shade; moving objects for every picture. The maps depend on the scene and the
/// camera only, not on earlier pictures.
/// </summary>
internal sealed class SceneShadows
{
    /// <summary>Two maps of this many texels a side: 128 m of fine ones and 819 m of coarse ones, metres each.</summary>
    private const int Texels = 1024;
    private const double NearTexel = 0.125;
    private const double FarTexel = 0.8;

    /// <summary>The maps lie around a place so far ahead of the camera, metres.</summary>
    private const double NearAhead = 44;
    private const double FarAhead = 250;

    /// <summary>The sun's direction is rounded to this step, about a quarter of a degree: so far it moves in a minute of its day.</summary>
    private const double SunStep = 1.0 / 256;

    /// <summary>A light weaker than this fraction of white casts no visible shadow.</summary>
    private const float MinSunlight = 0.012f;

    /// <summary>Places are raised by this many texels, and more on a slope, so that a surface does not shade itself.</summary>
    private const float BiasTexels = 0.8f;
    private const float MaxSlope = 5;

    private readonly ShadowMap _near = new(Texels);
    private readonly ShadowMap _far = new(Texels);
    private readonly SkyView _sky = new();
    private Vector3D _eye;
    private Vector3D _ahead;

    /// <summary>Whether the sun or moon casts shadows.</summary>
    public bool AreCast { get; private set; }

    /// <summary>Chooses the maps of a scene for a camera. What <see cref="Want"/> asks for is then drawn.</summary>
    public void Aim(RenderScene scene, RenderCamera camera)
    {
        Vector3 sunlight = Sky.ToLight(scene.Lighting.SunColour);
        AreCast = Math.Max(sunlight.X, Math.Max(sunlight.Y, sunlight.Z)) > MinSunlight;
        _eye = camera.Pose.Position;
        Vector3D forward = camera.Pose.Axes.Forward;
        _ahead = _eye + (forward * NearAhead);
        if (AreCast)
        {
            Vector3D sun = Rounded(scene.Lighting.SunDirection);
            _near.Aim(ShadowFrame.Around(sun, _ahead, NearTexel, Texels), scene.Static, _eye);
            _far.Aim(ShadowFrame.Around(sun, _eye + (forward * FarAhead), FarTexel, Texels), scene.Static, _eye);
        }
    }

    /// <summary>
    /// Asks for what <see cref="SunAt"/> needs to know at places; its parameters are the same. Several threads may ask at once.
    /// </summary>
    public void Want(in WideVector place, Vector3 normal, float facing)
    {
        float slope = SlopeOf(facing);
        WideVector near = InNear(place, normal, slope);
        Vector256<float> isNear = _near.IsWithin(near);
        _near.Want(near, isNear);
        if (!Vector256.EqualsAll(isNear.AsInt32(), Vector256<int>.AllBitsSet))
        {
            WideVector far = InFar(place, normal, slope);
            _far.Want(far, Vector256.AndNot(_far.IsWithin(far), isNear));
        }
    }

    /// <summary>Draws the maps.</summary>
    public void Draw(RenderScene scene)
    {
        Action drawSky = () => _sky.Draw(_ahead, _eye, scene);
        Action[] work = AreCast ? [drawSky, () => _near.Draw(scene), () => _far.Draw(scene)] : [drawSky];
        Parallel.Invoke(work);
    }

    /// <summary>The fraction of the sun's light that reaches places on a surface.</summary>
    /// <param name="place">Places relative to the camera.</param>
    /// <param name="normal">Unit normal of the surface, towards the camera.</param>
    /// <param name="facing">Cosine of the angle between the normal and the sun, greater than 0.</param>
    public Vector256<float> SunAt(in WideVector place, Vector3 normal, float facing)
    {
        float slope = SlopeOf(facing);
        WideVector near = InNear(place, normal, slope);
        Vector256<float> isNear = _near.IsWithin(near);
        Vector256<float> lit = isNear == Wide.Zero ? Wide.One : _near.Lit(near);
        if (Vector256.EqualsAll(isNear.AsInt32(), Vector256<int>.AllBitsSet))
        {
            return lit;
        }

        WideVector far = InFar(place, normal, slope);
        Vector256<float> farLit = Vector256.ConditionalSelect(_far.IsWithin(far), _far.Lit(far), Wide.One);
        return Vector256.ConditionalSelect(isNear, lit, farLit);
    }

    /// <summary>The fraction of the sky's light that reaches places on a surface.</summary>
    /// <param name="place">Places relative to the camera.</param>
    /// <param name="normal">Unit normal of the surface, towards the camera.</param>
    public Vector256<float> SkyAt(in WideVector place, Vector3 normal) => _sky.At(place, normal);

    // Tangent of the angle of incidence, √(1 - cos²) / cos: how much the height towards the sun changes over a texel.
    private static float SlopeOf(float facing) => Math.Min(MaxSlope, MathF.Sqrt(Math.Max(0, 1 - (facing * facing))) / facing);

    private WideVector InNear(in WideVector place, Vector3 normal, float slope) =>
        Raised(_near.InMap(place + WideVector.Of(normal * (float)NearTexel)), NearTexel, slope);

    private WideVector InFar(in WideVector place, Vector3 normal, float slope) =>
        Raised(_far.InMap(place + WideVector.Of(normal * (float)FarTexel)), FarTexel, slope);

    private static WideVector Raised(in WideVector inMap, double texel, float slope) =>
        new(inMap.X, inMap.Y, inMap.Z + Vector256.Create((float)texel * (BiasTexels + slope)));

    private static Vector3D Rounded(Vector3D direction) =>
        new Vector3D(
            Math.Round(direction.X / SunStep) * SunStep,
            Math.Round(direction.Y / SunStep) * SunStep,
            Math.Max(SunStep, Math.Round(direction.Z / SunStep) * SunStep)
        ).Normalized();
}
