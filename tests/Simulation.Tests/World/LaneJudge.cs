using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.World;

/// <summary>
/// Feels its way along lanes with rays against the triangles that are drawn: the ground below, the space above, and the way ahead.
/// </summary>
internal sealed class LaneJudge(IReadOnlyList<MeshInstance> shapes)
{
    /// <summary>The space that a lorry needs, metres above the lane.</summary>
    public const double ClearHeight = 4.5;

    private const double Step = 3;

    /// <summary>Lines along a lane, metres from its middle: about the width of a car.</summary>
    private static readonly double[] Lines = [-0.9, 0, 0.9];

    /// <summary>Height at which the way ahead must be free, metres.</summary>
    private const double Ahead = 0.8;

    /// <summary>Height above the lane from which the ground is felt, metres.</summary>
    private const double Feeler = 1;

    /// <summary>
    /// Difference of the ground from the lane's line, metres. Facets of asphalt deviate by centimetres from the curve, and where roads
    /// overlap they are up to 2 m long.
    /// </summary>
    private const double MaxUneven = 0.12;

    private readonly SceneRayCaster _rays = new(new RenderScene(shapes));

    /// <summary>Number of points that were judged.</summary>
    public int Judged { get; private set; }

    public IEnumerable<LaneFault> Faults(IEnumerable<LanePath> lanes) => lanes.SelectMany(Faults);

    private IEnumerable<LaneFault> Faults(LanePath lane)
    {
        foreach (double line in Lines)
        {
            Vector3D? before = null;
            for (double distance = 0; distance <= lane.Length; distance += Step)
            {
                (Vector3D middle, Vector3D tangent) = lane.Line.At(distance);
                Vector3D place = middle + (Horizontal.RightOf(tangent) * line);
                Judged++;
                if (FaultAt(place, line == 0) is { } fault)
                {
                    yield return fault;
                }

                if (before is { } last && Hit(last + (Horizontal.Up * Ahead), place - last, (place - last).Length) is { } free)
                {
                    yield return new LaneFault(LaneFaultKind.Barred, place, free);
                }

                before = place;
            }
        }
    }

    private LaneFault? FaultAt(Vector3D place, bool isMiddle)
    {
        if (Hit(place + (Horizontal.Up * Feeler), new Vector3D(0, 0, -1), 2 * Feeler) is not { } depth)
        {
            return new LaneFault(LaneFaultKind.NoGround, place, -Feeler);
        }

        double ground = Feeler - depth;
        if (isMiddle && Math.Abs(ground) > MaxUneven)
        {
            return new LaneFault(LaneFaultKind.Uneven, place, ground);
        }

        const double aboveGround = 0.3;
        Vector3D low = place + (Horizontal.Up * (Math.Max(0, ground) + aboveGround));
        return Hit(low, Horizontal.Up, ClearHeight - aboveGround) is { } free
            ? new LaneFault(LaneFaultKind.Low, place, free + aboveGround)
            : null;
    }

    private double? Hit(Vector3D from, Vector3D direction, double length) =>
        _rays.Cast(new Ray(from, direction), length, RayHit.World)?.Distance;
}
