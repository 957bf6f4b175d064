using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>How the ground looks from near: its grain, patches, tracks and snow. All of it depends on the place only.</summary>
internal sealed class GroundLook
{
    /// <summary>Noise per metre: the age of asphalt, patches, and a grain that is seen from near only.</summary>
    private const double AgesPerMetre = 0.03;
    private const double PatchesPerMetre = 0.35;
    private const double GrainsPerMetre = 5;
    private const double FineGrainsPerMetre = 9;
    private const float GrainReachMetres = 40;

    /// <summary>Farther away than this patches are finer than the pixels, metres.</summary>
    private const float PatchReachMetres = 110;

    /// <summary>Where the noise of patches is above this, asphalt has been patched and is darker.</summary>
    private const float PatchFrom = 0.66f;
    private const float PatchEdge = 40;
    private const float PatchDarkness = 0.16f;

    /// <summary>How much lighter old asphalt is than new asphalt, at least and at most.</summary>
    private const float MinBleaching = 0.08f;
    private const float MaxBleaching = 0.42f;

    /// <summary>How much darker asphalt is where wheels run.</summary>
    private const float TrackDarkness = 0.16f;

    /// <summary>Old asphalt has cracks, along lines on which a noise is in the middle of its range.</summary>
    private const double CracksPerMetre = 0.9;
    private const float CrackThinness = 42;
    private const float CrackDarkness = 0.22f;
    private const float CrackedFrom = 0.52f;
    private const float CrackedEdge = 5;

    /// <summary>Snow at the edge of what it covers, and on roads between the wheels.</summary>
    private const float SnowEdge = 2.5f;
    private const float SnowOnRoads = 0.85f;
    private const float SnowInTracks = 0.2f;

    private readonly NoisePlane _ages;
    private readonly NoisePlane _patches;
    private readonly NoisePlane _grains;
    private readonly NoisePlane _cracks;
    private readonly bool _isFull;

    /// <param name="eye">The point from which places are counted.</param>
    /// <param name="isFull">Whether asphalt is worn and snow lies unevenly.</param>
    public GroundLook(Vector3D eye, bool isFull)
    {
        _isFull = isFull;
        _ages = new NoisePlane(eye.X, eye.Y, AgesPerMetre);
        _cracks = new NoisePlane(eye.X, eye.Y, CracksPerMetre);
        _patches = new NoisePlane(eye.X, eye.Y, PatchesPerMetre);
        _grains = new NoisePlane(eye.X, eye.Y, isFull ? FineGrainsPerMetre : GrainsPerMetre);
    }

    /// <summary>Factors on the colour of places.</summary>
    /// <param name="place">Places relative to the eye.</param>
    /// <param name="distance">Their distances from it, metres.</param>
    /// <param name="surface">Ground or asphalt.</param>
    /// <param name="tracks">How much wheels run there, 0 to 1.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> GrainAt(in WideVector place, Vector256<float> distance, Surface surface, Vector256<float> tracks)
    {
        bool isWorn = _isFull && surface == Surface.Asphalt;
        Vector256<float> patch = _patches.At(place.X, place.Y);
        Vector256<float> grain = Wide.One + (Vector256.Create(0.10f) * (patch - Vector256.Create(0.5f)));
        Vector256<float> age = Wide.Zero;
        if (isWorn)
        {
            age = _ages.At(place.X, place.Y);
            Vector256<float> clear = Wide.Fraction(Vector256.Create(1.5f) - (distance * Vector256.Create(1.5f / PatchReachMetres)));
            grain += Vector256.Create(MinBleaching) + (Vector256.Create(MaxBleaching - MinBleaching) * age);
            grain -=
                Vector256.Create(PatchDarkness)
                * clear
                * Wide.Fraction((patch - Vector256.Create(PatchFrom)) * Vector256.Create(PatchEdge));
            grain -= Vector256.Create(TrackDarkness) * tracks * (Vector256.Create(0.5f) + patch);
        }

        Vector256<float> closeness = Wide.One - (distance * Vector256.Create(1 / GrainReachMetres));
        if (Vector256.GreaterThanAny(closeness, Wide.Zero))
        {
            Vector256<float> fine = _grains.At(place.X, place.Y) - Vector256.Create(0.5f);
            Vector256<float> near = Vector256.MaxNative(closeness, Wide.Zero);
            grain += Vector256.Create(_isFull ? 0.22f : 0.16f) * fine * near;
            if (isWorn)
            {
                // Where the ground is coarser, the crack is broken.
                Vector256<float> crack =
                    Wide.One - (Vector256.Abs(_cracks.At(place.X, place.Y) - Vector256.Create(0.5f)) * Vector256.Create(CrackThinness));
                Vector256<float> isCracked = Wide.Fraction((age - Vector256.Create(CrackedFrom)) * Vector256.Create(CrackedEdge));
                grain -= Vector256.Create(CrackDarkness) * Wide.Fraction(crack - fine) * isCracked * near;
            }
        }

        return grain;
    }

    /// <summary>How much snow lies on places, 0 to 1.</summary>
    /// <param name="place">Places relative to the eye.</param>
    /// <param name="surface">Ground or asphalt.</param>
    /// <param name="tracks">How much wheels run there, 0 to 1.</param>
    /// <param name="lying">How much lies on level ground on average.</param>
    public Vector256<float> SnowAt(in WideVector place, Surface surface, Vector256<float> tracks, float lying)
    {
        if (!_isFull || lying <= 0)
        {
            return Vector256.Create(lying);
        }

        // Rounded so that a full cover has no holes, and a thin one lies in patches.
        Vector256<float> uneven = (_patches.At(place.X, place.Y) - Vector256.Create(0.5f)) * Vector256.Create(1 - (0.6f * lying));
        Vector256<float> cover = Wide.Fraction(
            Vector256.Create(0.5f) + ((Vector256.Create(lying - 0.4f) + uneven) * Vector256.Create(SnowEdge))
        );
        return surface == Surface.Asphalt
            ? cover * Vector256.Create(SnowOnRoads) * (Wide.One - (tracks * Vector256.Create(1 - SnowInTracks)))
            : cover;
    }
}
