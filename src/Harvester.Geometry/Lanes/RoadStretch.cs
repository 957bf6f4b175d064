using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// The road that a car follows, unrolled: the links behind, under and ahead of it, in the direction of travel, with stations measured along
/// the centre line from the car. It ends where no link continues the road, or the lanes end.
/// </summary>
public sealed class RoadStretch
{
    /// <summary>Maximum height difference of a point from the road, metres; beyond it, the point is on another road.</summary>
    private const double MaxHeightDifference = 4;

    /// <summary>
    /// Maximum distance of a point beyond an end of a link that still counts as beside it, metres: room for the bend between two links.
    /// </summary>
    private const double OvershootTolerance = 0.5;

    /// <summary>Maximum distance of a point from the centre line, metres: no carriageway of the game is wider.</summary>
    private const double MaxLateralDistance = 50;

    private readonly List<StretchPiece> _pieces;

    private RoadStretch(List<StretchPiece> pieces) => _pieces = pieces;

    /// <summary>The links, in the order of travel.</summary>
    public IReadOnlyList<StretchPiece> Pieces => _pieces;

    /// <summary>Where the stretch begins, metres along the road from the car; 0 or less.</summary>
    public double StartStation => _pieces[0].StartStation;

    /// <summary>Where the stretch ends, metres along the road from the car; 0 or more.</summary>
    public double EndStation => _pieces[_pieces.Count - 1].EndStation;

    /// <summary>Unrolls the road from the car's position.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the lanes.</param>
    /// <param name="junctions">The extents of junctions.</param>
    /// <param name="match">The car's position on the network; it must have a road.</param>
    /// <param name="behind">How far back, metres; 0 or more.</param>
    /// <param name="ahead">How far ahead, metres; 0 or more.</param>
    /// <exception cref="ArgumentException">The match has no road.</exception>
    public static RoadStretch Follow(
        RoadCurves curves,
        LaneModel lanes,
        JunctionExtents junctions,
        RoadMatch match,
        double behind,
        double ahead
    )
    {
        Guard.NotNull(curves, nameof(curves));
        Guard.NotNull(lanes, nameof(lanes));
        Guard.NotNull(junctions, nameof(junctions));
        if (!match.HasRoad || PieceOf(curves, lanes, junctions, match.Link, match.IsForward, 0) is not { } own)
        {
            throw new ArgumentException("The car is on no road.", nameof(match));
        }

        own = own with { StartStation = -own.StationAt(match.Parameter) };
        var pieces = new List<StretchPiece> { own };
        var visited = new HashSet<int> { own.Link };
        while (
            pieces[pieces.Count - 1] is var last
            && last.EndStation < ahead
            && Beyond(curves, lanes, junctions, last, atEnd: true) is { } next
            && visited.Add(next.Link)
        )
        {
            pieces.Add(next with { StartStation = last.EndStation });
        }

        while (
            pieces[0] is var first
            && first.StartStation > -behind
            && Beyond(curves, lanes, junctions, first, atEnd: false) is { } previous
            && visited.Add(previous.Link)
        )
        {
            pieces.Insert(0, previous with { StartStation = first.StartStation - previous.Curve.Length });
        }

        return new RoadStretch(pieces);
    }

    /// <summary>The link at a station, or null beyond the stretch's ends.</summary>
    public StretchPiece? PieceAt(double station)
    {
        foreach (StretchPiece piece in _pieces)
        {
            if (station >= piece.StartStation && station <= piece.EndStation)
            {
                return piece;
            }
        }

        return null;
    }

    /// <summary>The point of the centre line at a station within the stretch, metres, world.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The station is beyond the stretch's ends.</exception>
    public Vector3D PointAt(double station) =>
        PieceAt(station) is { } piece
            ? piece.Curve.PointAt(piece.ParameterAt(station))
            : throw new ArgumentOutOfRangeException(nameof(station), station, "The stretch does not reach there.");

    /// <summary>Finds a point of the world on the road, beside the nearest link.</summary>
    /// <returns>Null if it is beside none of the stretch's links, or too far above or below them.</returns>
    public StretchPlace? Locate(Vector3D world)
    {
        var place = new Vector2D(world.X, world.Y);
        StretchPlace? found = null;
        double nearest = double.PositiveInfinity;
        foreach (StretchPiece piece in _pieces)
        {
            if (piece.Curve.IsBeyond(place, Math.Min(nearest, MaxLateralDistance)))
            {
                continue;
            }

            // The nearest link wins whose line has the point at its side: not beyond an end by more than the tolerance, and at about its
            // height.
            double parameter = piece.Curve.ClosestParameter(place);
            Vector3D onLine = piece.Curve.PointAt(parameter);
            Vector2D direction = piece.DirectionAt(parameter);
            Vector2D apart = place - new Vector2D(onLine.X, onLine.Y);
            if (
                Math.Abs(world.Z - onLine.Z) <= MaxHeightDifference
                && Math.Abs(apart.Dot(direction)) <= OvershootTolerance
                && apart.Length < nearest
            )
            {
                nearest = apart.Length;
                found = new StretchPlace(piece, piece.StationAt(parameter), -direction.Cross(apart));
            }
        }

        return found;
    }

    private static StretchPiece? Beyond(RoadCurves curves, LaneModel lanes, JunctionExtents junctions, StretchPiece piece, bool atEnd)
    {
        RoadLink link = curves.Network.Links[piece.Link];
        int node = piece.IsForward == atEnd ? link.To : link.From;
        int next = curves.Continuations.Of(piece.Link, beyondEnd: piece.IsForward == atEnd);
        if (next == RoadContinuations.None)
        {
            return null;
        }

        // Leaving through the end of this piece means entering the next at the same node.
        bool startsHere = curves.Network.Links[next].From == node;
        return PieceOf(curves, lanes, junctions, next, isForward: startsHere == atEnd, 0);
    }

    private static StretchPiece? PieceOf(
        RoadCurves curves,
        LaneModel lanes,
        JunctionExtents junctions,
        int link,
        bool isForward,
        double startStation
    )
    {
        if (lanes.LanesOf(link, isForward, 0) is null)
        {
            return null;
        }

        (double fromStart, double fromEnd) = junctions.Of(link);
        return new StretchPiece(
            link,
            isForward,
            curves.Of(link),
            startStation,
            lanes,
            isForward ? (fromStart, fromEnd) : (fromEnd, fromStart)
        );
    }
}
