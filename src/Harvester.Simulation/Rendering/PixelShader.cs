using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Light and air for each pixel, row by row.</summary>
internal sealed class PixelShader
{
    /// <summary>Noise of the ground per metre: patches, and a grain that is seen from near only.</summary>
    private const double PatchesPerMetre = 0.35;

    private const double GrainsPerMetre = 5;
    private const double FineGrainsPerMetre = 9;
    private const float GrainReachMetres = 40;

    /// <summary>Where the noise of patches is above this, the ground has been patched and is darker.</summary>
    private const float PatchFrom = 0.66f;
    private const float PatchEdge = 40;
    private const float PatchDarkness = 0.14f;

    /// <summary>How much lighter the ground is than new asphalt.</summary>
    private const float Bleaching = 0.25f;

    /// <summary>Seams of tar run where the noise of patches has this value.</summary>
    private const float SeamAt = 0.3f;
    private const float SeamThinness = 70;
    private const float SeamDarkness = 0.2f;
    private static readonly Vector3 Snow = new(0.95f, 0.96f, 1);

    private readonly Lighting _lighting;
    private readonly Sky _sky;
    private readonly LightMap _lights;
    private readonly ViewDirections _directions;
    private readonly NoisePlane _patches;
    private readonly NoisePlane _grains;
    private readonly Vector3 _sun;
    private readonly Vector3 _sunColour;
    private readonly Vector3 _ambient;
    private readonly float _near;
    private readonly float _night;
    private readonly float _rain;
    private readonly float _fog;
    private readonly float _haze;

    private readonly SceneShadows? _shadows;
    private readonly MarkingLayer? _markings;

    /// <param name="scene">What is drawn.</param>
    /// <param name="view">The camera's view.</param>
    /// <param name="shadows">The scene's shadows; null for none.</param>
    /// <param name="markings">The road markings; null if they are among the triangles.</param>
    public PixelShader(RenderScene scene, View view, SceneShadows? shadows, MarkingLayer? markings)
    {
        (_shadows, _markings) = (shadows, markings);
        _lighting = scene.Lighting;
        _sky = new Sky(_lighting);
        _lights = new LightMap(scene, view);
        _directions = new ViewDirections(view);
        Vector3D eye = view.Camera.Pose.Position;
        _patches = new NoisePlane(eye.X, eye.Y, PatchesPerMetre);
        _grains = new NoisePlane(eye.X, eye.Y, shadows is null ? GrainsPerMetre : FineGrainsPerMetre);
        _sun = Sky.ToSingle(_lighting.SunDirection);
        _sunColour = Sky.ToLight(_lighting.SunColour);
        _ambient = Sky.ToLight(_lighting.AmbientColour);
        _near = (float)view.Camera.NearClip;
        _night = (float)_lighting.NightFraction;
        _rain = (float)_lighting.RainFraction;
        _fog = (float)_lighting.FogDensity;
        _haze = Math.Min(1, _fog * 45);
    }

    /// <summary>Works out depths, directions and air of a row.</summary>
    /// <param name="row">The row, with its number.</param>
    /// <param name="nearness">Near / depth of its pixels; 0 for the sky.</param>
    public void Begin(PixelRow row, ReadOnlySpan<float> nearness)
    {
        _directions.Begin(row);
        nearness.CopyTo(row.Depths);
        for (int column = 0; column < nearness.Length; column += PixelRow.Step)
        {
            Vector256<float> depth = Vector256.Create(_near) / Vector256.Create(row.Depths, column);
            depth.CopyTo(row.Depths, column);
            Wide.Exp(Vector256.Create(-_fog) * depth * Vector256.Create(row.Stretch, column)).CopyTo(row.Through, column);
        }
    }

    /// <summary>Colours pixels of a row that show the sky.</summary>
    public void ShadeSky(PixelRow row, int first, int length)
    {
        WideVector horizon = WideVector.Of(_sky.Horizon);
        for (int column = first; column < first + length; column += PixelRow.Step)
        {
            WideVector direction = _directions.At(row, column) * (Wide.One / Vector256.Create(row.Stretch, column));
            row.Write(column, _sky.ColourAt(direction).Towards(horizon, Vector256.Create(_haze)));
        }
    }

    /// <summary>Colours pixels of a row that show one triangle.</summary>
    public void Shade(in ScreenTriangle triangle, PixelRow row, int first, int length)
    {
        // Everything is relative to the camera, so that single precision is enough anywhere in the world.
        Surface surface = triangle.Surface;
        Vector3 normal = triangle.Normal;
        float lying = SnowOn(surface, normal) * 0.7f;
        Vector3 colour = Sky.ToLight(triangle.Colour);
        Vector3 fromSky = _ambient * (0.8f + (0.2f * normal.Z));
        float facing = Math.Max(0, Vector3.Dot(normal, _sun));
        WideVector light = WideVector.Of(fromSky + (_sunColour * facing));
        WideVector own = WideVector.Of(Vector3.Lerp(colour, Snow, lying));
        WideVector lit = own * light;
        WideVector horizon = WideVector.Of(_sky.Horizon);
        bool isMarked = surface == Surface.Ground && _markings?.HasAny(row.Number) == true;
        for (int column = first; column < first + length; column += _lights.StepAt(column))
        {
            if (surface == Surface.Ground)
            {
                own = WideVector.Of(colour) * GrainAt(row, column);
                own = isMarked ? Marked(own, row.Number, column) : own;
                own = own.Towards(WideVector.Of(Snow), Vector256.Create(lying));
                lit = own * light;
            }

            if (_shadows is not null || _lights.AreLit)
            {
                WideVector place = _directions.At(row, column) * Vector256.Create(row.Depths, column);
                light = _shadows is null ? light : LightAt(place, normal, fromSky, facing);
                lit = own * (_lights.AreLit ? light + _lights.At(place, normal, column, row.Number) : light);
            }

            WideVector shown = surface switch
            {
                Surface.Lamp => own,
                Surface.NightLamp => lit.Towards(own, Vector256.Create(_night)),
                Surface.LitWindow => Mirrored(lit * Vector256.Create(0.2f), row, column, normal, 0.3f)
                    .Towards(own, Vector256.Create(_night)),
                Surface.Glass => Mirrored(lit, row, column, normal, 0.3f),
                Surface.Paint => Mirrored(lit, row, column, normal, 0.06f),
                Surface.Ground when _rain > 0 && _shadows is not null => lit * Vector256.Create(1 - (0.4f * _rain)),
                Surface.Ground when _rain > 0 =>
                    Mirrored(lit * Vector256.Create(1 - (0.3f * _rain)), row, column, normal, 0.09f * _rain),
                _ => lit,
            };
            row.Write(column, horizon.Towards(shown, Vector256.Create(row.Through, column)));
        }
    }

    /// <summary>Paint over asphalt, as far as it covers the pixels.</summary>
    private WideVector Marked(in WideVector asphalt, int row, int column)
    {
        ReadOnlySpan<float> coverage = _markings!.CoverageOf(row)[column..];
        ReadOnlySpan<Rgb> colours = _markings.ColoursOf(row)[column..];
        int count = Math.Min(PixelRow.Step, coverage.Length);
        Span<float> shares = stackalloc float[PixelRow.Step];
        coverage[..count].CopyTo(shares);
        Vector256<float> share = Vector256.Create<float>(shares);
        if (share == Wide.Zero)
        {
            return asphalt;
        }

        Span<float> channels = stackalloc float[3 * PixelRow.Step];
        for (int pixel = 0; pixel < count; pixel++)
        {
            Vector3 paint = Sky.ToLight(colours[pixel]);
            channels[pixel] = paint.X;
            channels[pixel + PixelRow.Step] = paint.Y;
            channels[pixel + (2 * PixelRow.Step)] = paint.Z;
        }

        var painted = new WideVector(
            Vector256.Create<float>(channels), Vector256.Create<float>(channels[PixelRow.Step..]),
            Vector256.Create<float>(channels[(2 * PixelRow.Step)..]));
        return asphalt.Towards(painted, share);
    }

    /// <summary>The light of sun and sky that shadows leave.</summary>
    private WideVector LightAt(in WideVector place, Vector3 normal, Vector3 fromSky, float facing)
    {
        WideVector light = WideVector.Of(fromSky) * _shadows!.SkyAt(place, normal);
        return facing > 0 && _shadows.AreCast ? light + (WideVector.Of(_sunColour * facing) * _shadows.SunAt(place, normal, facing))
            : light + WideVector.Of(_sunColour * facing);
    }

    /// <summary>Mixes in the mirrored sky, more of it at a grazing angle (Schlick's approximation).</summary>
    private WideVector Mirrored(in WideVector lit, PixelRow row, int column, Vector3 normal, float straightOn)
    {
        WideVector direction = _directions.At(row, column);
        Vector256<float> shrink = Wide.One / Vector256.Create(row.Stretch, column);
        Vector256<float> towards = direction.Dot(WideVector.Of(normal)) * shrink;
        Vector256<float> away = Wide.One - Wide.Fraction(-towards);
        away *= away;
        Vector256<float> share = Vector256.Create(straightOn) + (Vector256.Create(0.5f - (straightOn / 2)) * away * away);
        Vector256<float> height = (direction.Z * shrink) - (towards * Vector256.Create(2 * normal.Z));
        return lit.Towards(_sky.GradientAt(height), share);
    }

    /// <summary>How much snow lies on a surface, 0 to 1.</summary>
    private float SnowOn(Surface surface, Vector3 normal) => surface is Surface.Ground or Surface.Matte or Surface.Marking or Surface.Paint
        ? (float)_lighting.SnowFraction * Math.Clamp((normal.Z - 0.5f) * 2, 0, 1)
        : 0;

    /// <summary>A grain on the ground that fades where it would be finer than the pixels.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<float> GrainAt(PixelRow row, int column)
    {
        Vector256<float> depth = Vector256.Create(row.Depths, column);
        WideVector place = _directions.At(row, column) * depth;
        Vector256<float> patch = _patches.At(place.X, place.Y);
        Vector256<float> grain = Wide.One + (Vector256.Create(0.10f) * (patch - Vector256.Create(0.5f)));
        if (_shadows is not null)
        {
            grain += Vector256.Create(Bleaching);
            grain -= Vector256.Create(PatchDarkness) * Wide.Fraction((patch - Vector256.Create(PatchFrom)) * Vector256.Create(PatchEdge));
        }

        Vector256<float> closeness = Wide.One - (depth * Vector256.Create(row.Stretch, column) * Vector256.Create(1 / GrainReachMetres));
        if (Vector256.GreaterThanAny(closeness, Wide.Zero))
        {
            Vector256<float> fine = _grains.At(place.X, place.Y) - Vector256.Create(0.5f);
            Vector256<float> near = Vector256.MaxNative(closeness, Wide.Zero);
            grain += Vector256.Create(0.16f) * fine * near;
            if (_shadows is not null)
            {
                // Where the ground is coarser, the seam is broken.
                Vector256<float> seam = Wide.One - (Vector256.Abs(patch - Vector256.Create(SeamAt)) * Vector256.Create(SeamThinness));
                grain -= Vector256.Create(SeamDarkness) * Wide.Fraction(seam - fine) * near;
            }
        }

        return grain;
    }
}
