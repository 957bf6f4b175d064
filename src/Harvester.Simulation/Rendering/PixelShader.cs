using System;
using System.Numerics;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Light and air for each pixel.</summary>
internal sealed class PixelShader
{
    private readonly Lighting _lighting;
    private readonly Sky _sky;
    private readonly LightMap _lights;
    private readonly ViewDirections _directions;
    private readonly Vector3D _eye;
    private readonly Vector3 _sun;
    private readonly Vector3 _sunColour;
    private readonly Vector3 _ambient;
    private readonly float _night;
    private readonly float _rain;
    private readonly float _fog;
    private readonly float _haze;

    public PixelShader(RenderScene scene, View view)
    {
        _lighting = scene.Lighting;
        _sky = new Sky(_lighting);
        _lights = new LightMap(scene, view);
        _directions = new ViewDirections(view);
        _eye = view.Camera.Pose.Position;
        _sun = Sky.ToSingle(_lighting.SunDirection);
        _sunColour = Sky.ToLight(_lighting.SunColour);
        _ambient = Sky.ToLight(_lighting.AmbientColour);
        _night = (float)_lighting.NightFraction;
        _rain = (float)_lighting.RainFraction;
        _fog = (float)_lighting.FogDensity;
        _haze = Math.Min(1, _fog * 45);
    }

    /// <summary>Colours pixels of a row that show the sky.</summary>
    /// <param name="row">The row.</param>
    /// <param name="first">The first of the pixels.</param>
    /// <param name="colours">Red, green and blue of each.</param>
    public void ShadeSky(int row, int first, Span<byte> colours)
    {
        for (int i = 0; i < colours.Length; i += 3)
        {
            Vector3 sky = _sky.ColourAt(Vector3.Normalize(_directions.At(first + (i / 3), row)));
            Write(Vector3.Lerp(sky, _sky.Horizon, _haze), colours.Slice(i, 3));
        }
    }

    /// <summary>Colours pixels of a row that show one triangle.</summary>
    /// <param name="triangle">The triangle.</param>
    /// <param name="row">The row.</param>
    /// <param name="first">The first of the pixels.</param>
    /// <param name="depths">The depth of each, metres.</param>
    /// <param name="colours">Red, green and blue of each.</param>
    public void Shade(in ScreenTriangle triangle, int row, int first, ReadOnlySpan<float> depths, Span<byte> colours)
    {
        Surface surface = triangle.Surface;
        Vector3 normal = triangle.Normal;
        Vector3 plain = Sky.ToLight(triangle.Colour);
        float lying = SnowOn(surface, normal);
        Vector3 light = (_ambient * (0.8f + (0.2f * normal.Z))) + (_sunColour * Math.Max(0, Vector3.Dot(normal, _sun)));
        Vector3 own = Snowed(plain, lying);
        Vector3 lit = own * light;
        for (int i = 0; i < depths.Length; i++)
        {
            // Everything is relative to the camera, so that single precision is enough anywhere in the world.
            Vector3 direction = _directions.At(first + i, row);
            Vector3 place = direction * depths[i];
            float distance = place.Length();
            if (surface == Surface.Ground)
            {
                own = Snowed(plain * GrainAt(place, distance), lying);
            }

            if (surface == Surface.Ground || _lights.AreLit)
            {
                lit = own * (_lights.AreLit ? light + _lights.At(place, normal, first + i, row) : light);
            }

            Vector3 shown = surface switch
            {
                Surface.Lamp => own,
                Surface.NightLamp => Vector3.Lerp(lit, own, _night),
                Surface.LitWindow => Vector3.Lerp(Mirrored(lit * 0.2f, direction, normal, 0.3f), own, _night),
                Surface.Glass => Mirrored(lit, direction, normal, 0.3f),
                Surface.Paint => Mirrored(lit, direction, normal, 0.06f),
                Surface.Ground when _rain > 0 => Mirrored(lit * (1 - (0.3f * _rain)), direction, normal, 0.09f * _rain),
                _ => lit,
            };
            float through = MathF.Exp(-_fog * distance);
            Write(Vector3.Lerp(_sky.Horizon, shown, through), colours.Slice(i * 3, 3));
        }
    }

    /// <summary>Mixes in the mirrored sky, more of it at a grazing angle (Schlick's approximation).</summary>
    private Vector3 Mirrored(Vector3 lit, Vector3 direction, Vector3 normal, float straightOn)
    {
        direction = Vector3.Normalize(direction);
        float cosine = Math.Clamp(-Vector3.Dot(direction, normal), 0, 1);
        float away = 1 - cosine;
        float share = straightOn + ((0.5f - (straightOn / 2)) * away * away * away * away);
        return Vector3.Lerp(lit, _sky.GradientAt(Vector3.Reflect(direction, normal)), share);
    }

    /// <summary>How much snow lies on a surface, 0 to 1.</summary>
    private float SnowOn(Surface surface, Vector3 normal) => surface is Surface.Ground or Surface.Matte or Surface.Paint
        ? (float)_lighting.SnowFraction * Math.Clamp((normal.Z - 0.5f) * 2, 0, 1)
        : 0;

    private static Vector3 Snowed(Vector3 own, float lying) =>
        lying > 0 ? Vector3.Lerp(own, new Vector3(0.95f, 0.96f, 1), lying * 0.7f) : own;

    /// <summary>A grain on the ground that fades where it would be finer than the pixels.</summary>
    private float GrainAt(Vector3 place, float distance)
    {
        var x = (float)(_eye.X + place.X);
        var y = (float)(_eye.Y + place.Y);
        float coarse = Noise.At(x * 0.35f, y * 0.35f) - 0.5f;
        float fine = distance < 40 ? (Noise.At(x * 5, y * 5) - 0.5f) * (1 - (distance / 40)) : 0;
        return 1 + (0.10f * coarse) + (0.16f * fine);
    }

    private static void Write(Vector3 light, Span<byte> colour)
    {
        Vector128<float> scaled = (light.AsVector128() * 255) + Vector128.Create(0.5f);
        Vector128<int> bytes = Vector128.ConvertToInt32(
            Vector128.Min(Vector128.Max(scaled, Vector128<float>.Zero), Vector128.Create(255f)));
        colour[2] = (byte)bytes[2];
        colour[1] = (byte)bytes[1];
        colour[0] = (byte)bytes[0];
    }
}
