using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>The ground truth of the lanes, for testing everything that finds lanes from nodes or images.</summary>
public sealed class RoadTruth
{
    private const double SameLevel = 3;

    /// <summary>Maximum distance of paths through a junction from its carriageways, metres.</summary>
    private const double JunctionMargin = 10;

    private readonly StreetIndex _index;

    internal RoadTruth(StreetIndex index) => _index = index;

    /// <summary>Finds a body's position among the lanes.</summary>
    /// <param name="position">A point of it near the ground, metres, world.</param>
    /// <param name="forward">The direction in which it faces.</param>
    /// <returns>The road under it that best matches its direction or, in a junction outside all lanes, a road beside it; null if there is
    /// no road.</returns>
    public LanePosition? Locate(Vector3D position, Vector3D forward)
    {
        if (BestAlong(forward, _index.PlacesAt(position).Where(place => place.IsOnCarriageway(0))) is { } on)
        {
            return Describe(on, position, forward);
        }

        IEnumerable<RoadPlace> ends = _index
            .PlacesAt(position, JunctionMargin)
            .Where(place => place.Road.IsInTrim(place.Distance) && place.IsOnCarriageway(JunctionMargin));
        return BestAlong(forward, ends) is { } beside
            ? Describe(beside, position, forward) with
            {
                Lane = null,
                RightOfLaneCentre = 0,
            }
            : null;
    }

    private static RoadPlace? BestAlong(Vector3D forward, IEnumerable<RoadPlace> places) =>
        places
            .Where(place => Math.Abs(place.Height) < SameLevel)
            .OrderBy(place => Math.Min(HeadingMisfit(place, forward, true), HeadingMisfit(place, forward, false)))
            .Cast<RoadPlace?>()
            .FirstOrDefault();

    /// <summary>Angle between a direction and the traffic on one side of a road; larger than any angle if that side has no lanes.</summary>
    private static double HeadingMisfit(RoadPlace place, Vector3D forward, bool along) =>
        place.Road.Layout.Lanes(along) > 0 ? Math.Abs(Horizontal.Turn(along ? place.Tangent : -place.Tangent, forward)) : 4;

    private LanePosition Describe(RoadPlace place, Vector3D position, Vector3D forward)
    {
        LaneLayout layout = place.Road.Layout;
        bool drivesForward = Horizontal.Turn(place.Tangent, forward) is > -Math.PI / 2 and < Math.PI / 2;
        Vector3D direction = drivesForward ? place.Tangent : -place.Tangent;
        (bool Forward, int Lane)? lane = layout.LaneAt(place.RightOffset);
        bool isOncoming = lane is { } at && at.Forward != drivesForward;
        double toCentre = lane is { } own ? place.RightOffset - layout.LaneCentre(own.Forward, own.Lane) : 0;
        return new LanePosition(
            place.Road.Index,
            drivesForward,
            place.Distance,
            drivesForward ? place.RightOffset : -place.RightOffset,
            lane is null || isOncoming ? null : lane.Value.Lane,
            layout.Lanes(drivesForward),
            layout.Lanes(!drivesForward),
            layout.LaneWidth,
            layout.IsOneWay ? 0 : layout.MedianWidth,
            drivesForward ? toCentre : -toCentre,
            Horizontal.Turn(forward, direction),
            (drivesForward ? 1 : -1) * place.Road.Curve.CurvatureAt(place.Distance),
            place.Road.IsInner || place.Road.IsInTrim(place.Distance) || _index.IsOnAnother(place.Road, position, 0)
        );
    }
}
