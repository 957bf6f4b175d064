namespace Harvester.Geometry.Roads;

/// <summary>
/// Finds the road, direction and lane of a car from its position and heading. Every direction of every link nearby is rated by how far the
/// car is outside its carriageway, how its heading and height differ (bridges), and whether it is the road followed before or one that this
/// road leads to. Immutable, and so safe for any number of threads.
/// </summary>
public sealed class RoadMatcher
{
    /// <summary>Cost of the distance from the middle of a lane, at its edge: cars keep to the middle, loosely.</summary>
    private const double CostOfLaneEdge = 0.5;

    /// <summary>Maximum cost of a car outside the lanes: an overtaking car still follows its road.</summary>
    private const double MaxCostOfBeside = 14;

    /// <summary>Maximum number of links along the road between two candidates that count as the same road.</summary>
    private const int LinksOfSameRoad = 3;

    /// <summary>Deviation along the road beyond the end of a link, metres: the next link fits better.</summary>
    private const double OvershootDeviation = 0.5;

    private readonly RoadCurves _curves;
    private readonly RoadNetwork _network;
    private readonly LaneModel _lanes;
    private readonly RoadMatcherOptions _options;
    private readonly RoadIndex _index;
    private readonly double[] _reach;
    private readonly double _headingDeviation;
    private readonly double _largestHeadingError;

    /// <summary>Creates a matcher; its index is built once.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">How wide the lanes are.</param>
    /// <param name="options">Deviations and costs; null for the defaults.</param>
    public RoadMatcher(RoadCurves curves, LaneModel lanes, RoadMatcherOptions? options = null)
    {
        _curves = Guard.NotNull(curves, nameof(curves));
        _network = curves.Network;
        _lanes = Guard.NotNull(lanes, nameof(lanes));
        _options = options ?? new RoadMatcherOptions();
        _headingDeviation = Angles.ToRadians(_options.HeadingDeviationDegrees);
        _largestHeadingError = Angles.ToRadians(_options.MaxHeadingErrorDegrees);
        Junctions = new JunctionExtents(curves, lanes);
        _reach = new double[_network.Links.Count];
        for (int i = 0; i < _reach.Length; i++)
        {
            _reach[i] =
                Math.Max(_lanes.RightEdgeOf(i, isForward: true) ?? 0, _lanes.RightEdgeOf(i, isForward: false) ?? 0)
                + _options.MaxDistanceBeside;
        }

        _index = new RoadIndex(curves, link => _reach[link]);
    }

    /// <summary>The extents of the network's junctions.</summary>
    public JunctionExtents Junctions { get; }

    /// <summary>Matches one position of a car.</summary>
    /// <param name="position">Metres, world, near the height of the road.</param>
    /// <param name="headingDegrees">The car's heading, degrees counter-clockwise from north.</param>
    /// <param name="previous">The match of the frame before, whose road is preferred; null if there is none.</param>
    /// <exception cref="ArgumentOutOfRangeException">The position or heading is not finite.</exception>
    public RoadMatch Match(Vector3D position, double headingDegrees, RoadMatch? previous = null)
    {
        Guard.Finite(position, nameof(position));
        double heading = Angles.ToRadians(Guard.Finite(headingDegrees, nameof(headingDegrees)));
        var forward = new Vector2D(-Math.Sin(heading), Math.Cos(heading));
        RoadCandidate? best = null;
        RoadCandidate? runnerUp = null;
        double crossing = double.PositiveInfinity; // Cost of the best way through a junction, whichever road was followed.
        bool isRoadNear = false;
        ArraySegment<int> near = _index.Near(position);
        for (int i = near.Offset; i < near.Offset + near.Count; i++)
        {
            if (Candidate(near.Array![i], position, forward, previous, ref isRoadNear) is { } candidate)
            {
                crossing = IsInJunction(candidate) ? Math.Min(crossing, candidate.CostOfPlace) : crossing;
                if (best is null || candidate.Cost < best.Value.Cost)
                {
                    runnerUp = RunnerUp(runnerUp, best, candidate);
                    best = candidate;
                }
                else
                {
                    runnerUp = RunnerUp(runnerUp, candidate, best.Value);
                }
            }
        }

        return best is { } found && found.Cost < _options.CostOfUnknownRoad
            ? Result(Beside(found, position, forward, previous), runnerUp, crossing)
            : new RoadMatch { Outcome = isRoadNear ? RoadMatchOutcome.NotAlongAnyRoad : RoadMatchOutcome.NoRoadNear };
    }

    /// <summary>
    /// The link of a road that a car is beside: if it is past the end of the link that fits best, the next one that it has not passed.
    /// </summary>
    private RoadCandidate Beside(RoadCandidate found, Vector3D position, Vector2D forward, RoadMatch? previous)
    {
        for (int step = 0; step < LinksOfSameRoad && found.Overshoot != 0; step++)
        {
            int next = _curves.Continuations.Of(found.Link, beyondEnd: found.Overshoot > 0);
            bool isRoadNear = false;
            if (
                next == RoadContinuations.None
                || Candidate(next, position, forward, previous, ref isRoadNear) is not { } beyond
                || Math.Abs(beyond.Overshoot) >= Math.Abs(found.Overshoot)
            )
            {
                break;
            }

            found = beyond;
        }

        return found;
    }

    /// <summary>The better of two candidates that are not on the winner's road.</summary>
    private RoadCandidate? RunnerUp(RoadCandidate? runnerUp, RoadCandidate? other, RoadCandidate winner)
    {
        RoadCandidate? old = runnerUp is { } r && !IsSameRoad(r.Link, r.IsForward, winner) ? runnerUp : null;
        return other is { } o && !IsSameRoad(o.Link, o.IsForward, winner) && (old is null || o.Cost < old.Value.Cost) ? other : old;
    }

    private RoadCandidate? Candidate(int link, Vector3D position, Vector2D forward, RoadMatch? previous, ref bool isRoadNear)
    {
        RoadCurve curve = _curves.Of(link);
        var place = new Vector2D(position.X, position.Y);
        if (curve.IsBeyond(place, _reach[link]))
        {
            return null;
        }

        double parameter = curve.ClosestParameter(place);

        // In units of its deviation, as the other misfits below.
        double height = (position.Z - curve.HeightAt(parameter)) / _options.HeightDeviation;
        if (Math.Abs(height) * _options.HeightDeviation > _options.MaxHeightDifference)
        {
            return null;
        }

        Vector2D apart = place - curve.GroundAt(parameter);
        Vector2D along = curve.DirectionAt(parameter);
        bool isForward = along.Dot(forward) >= 0;
        along = isForward ? along : along * -1;

        // Angle from the car's heading to the road's, positive to the left; the offset to the right of the line is -(along × apart).
        double headingError = Math.Atan2(forward.Cross(along), forward.Dot(along));
        double right = -along.Cross(apart);
        double overshoot = parameter is 0 or 1 ? along.Dot(apart) * (isForward ? 1 : -1) : 0;
        (LaneSection Section, double LeftEdge)? lanes = _lanes.LanesOf(link, isForward, curve.StationAt(parameter));
        if (lanes is not { } there)
        {
            isRoadNear |= Math.Abs(right) < _options.MaxDistanceBeside && Math.Abs(along.Dot(apart)) < OvershootDeviation;
            return null;
        }

        double offset = right - there.LeftEdge;
        double width = there.Section.Width;
        double outside = Math.Max(0, Math.Max(-offset, offset - width));
        if (outside > _options.MaxDistanceBeside)
        {
            return null;
        }

        isRoadNear |= Math.Abs(along.Dot(apart)) < OvershootDeviation;
        if (Math.Abs(headingError) > _largestHeadingError)
        {
            return null;
        }

        // 0 in the middle of a lane, 1 at its edge and outside the lanes.
        int nearest = there.Section.NearestLane(offset);
        double fromMiddle = outside > 0 ? 1 : Math.Abs(offset - there.Section.MiddleOf(nearest)) * 2 / there.Section.WidthOf(nearest);

        // -2 ln of the likelihood of independent normal misfits, up to a constant: the sum of squared misfits in units of their deviations.
        double cost =
            Math.Min(Square(outside / _options.LateralDeviation), MaxCostOfBeside)
            + Square(headingError / _headingDeviation)
            + Square(height)
            + Square(along.Dot(apart) / OvershootDeviation)
            + (CostOfLaneEdge * Square(fromMiddle));
        return new RoadCandidate(
            link,
            isForward,
            parameter,
            there.Section,
            there.LeftEdge,
            offset,
            headingError,
            overshoot,
            cost,
            cost + CostOfHistory(link, isForward, previous)
        );
    }

    private double CostOfHistory(int link, bool isForward, RoadMatch? previous)
    {
        if (
            previous is { HasRoad: true } before
            && IsSameRoad(before.Link, before.IsForward, new RoadCandidate { Link = link, IsForward = isForward })
        )
        {
            return 0;
        }

        RoadLink road = _network.Links[link];
        bool isSlipLane = (_network.Nodes[road.From].Flags & _network.Nodes[road.To].Flags & RoadNodeFlags.SlipLane) != 0;
        double slip = isSlipLane ? _options.CostOfSlipLane : 0;
        if (previous is not { HasRoad: true } left)
        {
            return slip;
        }

        RoadLink old = _network.Links[left.Link];
        int way = left.IsForward ? old.To : old.From;

        // The node at which the road followed before is left: a link that begins there costs half.
        bool leadsThere = (isForward ? road.From : road.To) == way;
        return slip + (leadsThere ? _options.CostOfLeaving / 2 : _options.CostOfLeaving);
    }

    /// <summary>Whether a directed link is another candidate's, or one of the next links of its road either way.</summary>
    private bool IsSameRoad(int link, bool isForward, RoadCandidate other)
    {
        if (link == other.Link)
        {
            return isForward == other.IsForward;
        }

        return IsAhead(link, isForward, other) || IsAhead(link, !isForward, other with { IsForward = !other.IsForward });
    }

    private bool IsAhead(int link, bool isForward, RoadCandidate other)
    {
        for (int step = 0; step < LinksOfSameRoad; step++)
        {
            int node = isForward ? _network.Links[link].To : _network.Links[link].From;
            link = _curves.Continuations.Of(link, isForward);
            if (link == RoadContinuations.None)
            {
                return false;
            }

            isForward = _network.Links[link].From == node;
            if (link == other.Link)
            {
                return isForward == other.IsForward;
            }
        }

        return false;
    }

    private RoadMatch Result(RoadCandidate found, RoadCandidate? runnerUp, double crossing)
    {
        // Posterior probability of the best candidate with equal priors: e^(-c/2) divided by the sum of it for the best, the runner-up and
        // a road missing from the data.
        double unknown = Math.Exp((found.Cost - _options.CostOfUnknownRoad) / 2);
        double other = runnerUp is { } second ? Math.Exp((found.Cost - second.Cost) / 2) : 0;
        double confidence = 1 / (1 + unknown + other);
        double width = found.Section.Width;
        double outside = Math.Max(-found.Offset, found.Offset - width);
        int? lane = outside * found.Section.TorcsScale > _options.EdgeTolerance ? null : found.Section.NearestLane(found.Offset);
        return new RoadMatch
        {
            Outcome =
                lane is null ? RoadMatchOutcome.BesideTheLanes
                : confidence < _options.MinConfidence ? RoadMatchOutcome.Ambiguous
                : RoadMatchOutcome.Matched,
            Link = found.Link,
            IsForward = found.IsForward,
            Parameter = found.Parameter,
            Section = found.Section,
            LeftEdge = found.LeftEdge,
            OffsetFromLeftEdge = found.Offset,
            Lane = lane,
            HeadingError = found.HeadingError,
            Confidence = confidence,
            InJunction = IsInJunction(found) || crossing < found.CostOfPlace,
        };
    }

    private bool IsInJunction(RoadCandidate candidate) =>
        Junctions.Contains(candidate.Link, _curves.Of(candidate.Link).StationAt(candidate.Parameter));

    private static double Square(double value) => value * value;
}
