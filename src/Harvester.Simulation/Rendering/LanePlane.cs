using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Where the wheels of traffic run on a triangle of asphalt.</summary>
internal readonly struct LanePlane
{
    /// <summary>Wheels run so far from the middle of a lane, in widths of a lane: cars are narrower than GTA's lanes of 5.4 m.</summary>
    private const float TrackAt = 0.145f;

    /// <summary>Half the width of a track with its blurred edges, in widths of a lane.</summary>
    private const float HalfTrack = 0.075f;

    private readonly Vector3 _perMetre;
    private readonly float _inner;
    private readonly float _outer;

    /// <param name="triangle">The triangle, in the frame of its mesh.</param>
    /// <param name="pose">The pose of the mesh.</param>
    /// <param name="eye">The point from which places are counted.</param>
    public LanePlane(in MeshTriangle triangle, Pose pose, Vector3D eye)
    {
        LaneOffsets lanes = triangle.Lanes;
        Vector3D a = pose.ToWorld(triangle.A) - eye;
        Vector3D ab = pose.ToWorld(triangle.B) - eye - a;
        Vector3D ac = pose.ToWorld(triangle.C) - eye - a;
        double area = (ab.X * ac.Y) - (ab.Y * ac.X);
        if (lanes.Outer <= 0 || area == 0)
        {
            return;
        }

        // The offset in lanes is linear over the triangle: Cramer's rule for its slopes to the east and to the north.
        double b = lanes.B - lanes.A;
        double c = lanes.C - lanes.A;
        double east = ((b * ac.Y) - (c * ab.Y)) / area;
        double north = ((ab.X * c) - (ac.X * b)) / area;
        _perMetre = new Vector3((float)east, (float)north, (float)(lanes.A - (east * a.X) - (north * a.Y)));
        (_inner, _outer) = (lanes.Inner, lanes.Outer);
    }

    /// <summary>Whether traffic runs on it.</summary>
    public bool HasLanes => _outer > 0;

    /// <summary>How much wheels run over places, 0 to 1.</summary>
    /// <param name="place">Places relative to the eye.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> TracksAt(in WideVector place)
    {
        Vector256<float> across = Vector256.Abs(
            (place.X * Vector256.Create(_perMetre.X)) + (place.Y * Vector256.Create(_perMetre.Y)) + Vector256.Create(_perMetre.Z)
        );
        Vector256<float> lanes = across - Vector256.Create(_inner);

        // Distance from the middle of the lane, in widths of a lane, then from the nearer wheel track, in half widths of it.
        Vector256<float> fromMiddle = Vector256.Abs(lanes - Vector256.Floor(lanes) - Vector256.Create(0.5f));
        Vector256<float> fromTrack = Vector256.Abs(fromMiddle - Vector256.Create(TrackAt)) * Vector256.Create(1 / HalfTrack);
        Vector256<float> isOnLane = Vector256.GreaterThan(lanes, Wide.Zero) & Vector256.LessThan(across, Vector256.Create(_outer));
        return isOnLane & Wide.Fraction(Vector256.Create(2f) * (Wide.One - fromTrack));
    }
}
