using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// Finds the lanes around a car. The car's position across the road is measured from the road's curved line, so that a bend is not mistaken
/// for leaving the lane; the direction of the road, its lanes and their width are those at the look-ahead point. In junctions and off the
/// road, the lanes are unknown.
/// </summary>
public sealed class LaneObserver
{
    /// <summary>Length of road that decides whether it is straight ahead, and how far apart its direction is compared, metres.</summary>
    private const double StraightMetres = 60;
    private const double SampleMetres = 5;

    /// <summary>How far behind the car its road is followed, metres.</summary>
    private const double BehindMetres = 10;

    /// <summary>A road that turns by less than this over 60 m is straight, radians: a radius of at least 60 / 0.05 = 1,200 m.</summary>
    private const double StraightTurn = 0.05;

    private readonly RoadCurves _curves;
    private readonly LaneModel _lanes;
    private readonly RoadMatcher _matcher;
    private readonly LookAhead _lookAhead;

    /// <summary>Creates an observer of a road network.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the lanes.</param>
    /// <param name="lookAhead">Where to measure; null for the thesis's ten metres.</param>
    public LaneObserver(RoadCurves curves, LaneModel lanes, LookAhead? lookAhead = null)
    {
        _curves = Guard.NotNull(curves, nameof(curves));
        _lanes = Guard.NotNull(lanes, nameof(lanes));
        _matcher = new RoadMatcher(curves, lanes);
        _lookAhead = lookAhead ?? LookAhead.Thesis;
    }

    /// <summary>Observes the lanes around a car.</summary>
    /// <param name="position">Centre of the car, metres, world, near the height of the road.</param>
    /// <param name="headingDegrees">Degrees counter-clockwise from north.</param>
    /// <param name="speed">Metres per second; for a look-ahead in seconds.</param>
    /// <param name="length">The car's length, metres; for distances bumper to bumper.</param>
    /// <param name="vehicles">Vehicles around; those not ahead on the same road are ignored.</param>
    /// <param name="previous">The match of the frame before, whose road is preferred; null if there is none.</param>
    /// <exception cref="ArgumentOutOfRangeException">The position or heading is not finite.</exception>
    public LaneObservation Observe(
        Vector3D position,
        double headingDegrees,
        double speed,
        double length,
        IReadOnlyList<TrafficVehicle> vehicles,
        RoadMatch? previous
    )
    {
        Guard.NotNull(vehicles, nameof(vehicles));
        RoadMatch match = _matcher.Match(position, headingDegrees, previous);
        LaneStatus status = StatusOf(match);
        if (!match.HasRoad)
        {
            return new LaneObservation { Status = status, Match = match };
        }

        RoadStretch stretch = RoadStretch.Follow(
            _curves,
            _lanes,
            _matcher.Junctions,
            match,
            BehindMetres,
            IndicatorCalculator.VehicleRange
        );
        var observation = new LaneObservation
        {
            Status = status,
            Match = match,
            Stretch = stretch,
            WidthSource = stretch.PieceAt(0)!.WidthSourceAt(0),
        };
        return status == LaneStatus.Known ? Measured(observation, stretch, match, headingDegrees, speed, length, vehicles) : observation;
    }

    private static LaneStatus StatusOf(RoadMatch match) =>
        match.Outcome switch
        {
            RoadMatchOutcome.NoRoadNear => LaneStatus.OffRoad,
            RoadMatchOutcome.NotAlongAnyRoad => LaneStatus.NotAlongRoad,
            _ when match.InJunction => LaneStatus.InJunction,
            RoadMatchOutcome.BesideTheLanes => LaneStatus.BesideLanes,
            RoadMatchOutcome.Ambiguous => LaneStatus.Ambiguous,
            _ => LaneStatus.Known,
        };

    private LaneObservation Measured(
        LaneObservation observation,
        RoadStretch stretch,
        RoadMatch match,
        double headingDegrees,
        double speed,
        double length,
        IReadOnlyList<TrafficVehicle> vehicles
    )
    {
        double offset = match.LeftEdge + match.OffsetFromLeftEdge;
        double lookAhead = Math.Min(_lookAhead.DistanceAt(speed), stretch.EndStation);
        StretchPiece there = stretch.PieceAt(lookAhead)!;
        (LaneSection section, double leftEdge) = there.LanesAt(lookAhead);
        LaneWidthSource source = there.WidthSourceAt(lookAhead);
        double ahead = offset + (IsPaint(observation.WidthSource) && IsPaint(source) ? Moved(match, section, leftEdge) : 0) - leftEdge;
        double parameter = there.ParameterAt(lookAhead);
        IReadOnlyList<VehicleInLane> inLanes = VehiclesAhead(stretch, length, vehicles);
        List<VehicleAhead> own = OwnDirection(inLanes);
        return observation with
        {
            LookAheadMetres = lookAhead,
            WidthSource = WidthSourceOf(observation.WidthSource, source),
            Section = section,
            OffsetFromLeftEdge = ahead,
            Indicators = IndicatorCalculator.Compute(AngleOf(there.DirectionAt(parameter), headingDegrees), ahead, section, own),
            SectionAtCar = match.Section,
            IndicatorsAtCar = IndicatorCalculator.Compute(match.HeadingError, match.OffsetFromLeftEdge, match.Section, own),
            CurvaturePerMetre = there.CurvatureAt(parameter),
            IsFast = IsStraightAhead(stretch),
            Vehicles = inLanes,
        };
    }

    /// <summary>The source of the lanes at the car, or the one at the look-ahead point where only those at the car are painted.</summary>
    private static LaneWidthSource? WidthSourceOf(LaneWidthSource? here, LaneWidthSource there) =>
        IsPaint(here) && there != LaneWidthSource.Paint ? there : here;

    private static bool IsPaint(LaneWidthSource? source) => source is LaneWidthSource.Paint or LaneWidthSource.PartlyPaint;

    /// <summary>
    /// How far the middle of the painted lanes moves from the car to the look-ahead point, metres to the right of the road's line: paint
    /// does not follow this line exactly, and a car that follows the road follows the paint. 0 if the number of lanes changes.
    /// </summary>
    private static double Moved(RoadMatch here, LaneSection section, double leftEdge) =>
        here.Section.LaneCount == section.LaneCount ? leftEdge + (section.Width / 2) - (here.LeftEdge + (here.Section.Width / 2)) : 0;

    private static double AngleOf(Vector2D road, double headingDegrees)
    {
        double roadHeading = Angles.HeadingDegrees(new Vector3D(road.X, road.Y, 0));
        return Angles.WrapRadians(Angles.ToRadians(roadHeading - headingDegrees));
    }

    private static bool IsStraightAhead(RoadStretch stretch)
    {
        if (stretch.EndStation < StraightMetres)
        {
            return false;
        }

        Vector2D here = DirectionAt(stretch, 0);
        for (double station = SampleMetres; station <= StraightMetres; station += SampleMetres)
        {
            Vector2D there = DirectionAt(stretch, station);
            if (Math.Abs(Math.Atan2(here.Cross(there), here.Dot(there))) > StraightTurn)
            {
                return false;
            }
        }

        return true;
    }

    private static Vector2D DirectionAt(RoadStretch stretch, double station)
    {
        StretchPiece piece = stretch.PieceAt(station)!;
        return piece.DirectionAt(piece.ParameterAt(station));
    }

    private static List<VehicleInLane> VehiclesAhead(RoadStretch stretch, double length, IReadOnlyList<TrafficVehicle> vehicles)
    {
        var found = new List<VehicleInLane>();
        foreach (TrafficVehicle vehicle in vehicles)
        {
            if (
                stretch.Locate(vehicle.Position) is { Station: > 0 and <= IndicatorCalculator.VehicleRange } place
                && LaneOf(place, vehicle.HeadingDegrees) is { } lane
            )
            {
                found.Add(
                    new VehicleInLane(
                        vehicle.Id,
                        lane.Lane,
                        lane.IsOncoming,
                        place.Station,
                        // Gap from bumper to bumper: the distance of the centres minus half of both lengths.
                        place.Station - ((length + vehicle.Length) / 2)
                    )
                );
            }
        }

        found.Sort(static (a, b) => a.DistanceMetres.CompareTo(b.DistanceMetres));
        return found;
    }

    private static (int Lane, bool IsOncoming)? LaneOf(StretchPlace place, double headingDegrees)
    {
        StretchPiece piece = place.Piece;
        Vector2D road = piece.DirectionAt(piece.ParameterAt(place.Station));

        // A vehicle belongs to the direction that it faces, less than 90° from the road's.
        bool drivesAlong = Math.Abs(AngleOf(road, headingDegrees)) < Math.PI / 2;
        if (drivesAlong)
        {
            return piece.LanesAt(place.Station).Section.LaneAt(place.OffsetFromLeftEdge) is { } lane ? (lane, false) : null;
        }

        // Offsets of the other direction are measured from the same line with the opposite sign.
        return piece.OncomingAt(place.Station) is { } oncoming && oncoming.Section.LaneAt(-place.Offset - oncoming.LeftEdge) is { } opposite
            ? (opposite, true)
            : null;
    }

    private static List<VehicleAhead> OwnDirection(IReadOnlyList<VehicleInLane> vehicles)
    {
        var own = new List<VehicleAhead>();
        foreach (VehicleInLane vehicle in vehicles)
        {
            if (!vehicle.IsOncoming)
            {
                own.Add(new VehicleAhead(vehicle.Lane, vehicle.DistanceMetres));
            }
        }

        return own;
    }
}
