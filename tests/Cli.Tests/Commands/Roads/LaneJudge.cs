using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Streets;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Compares labelled indicators with the true lanes of a simulated game. The true boundary of a lane is the middle of the line painted at
/// the edge that the game's layout gives the lane, or this edge itself where none is painted. Every frame whose label says that the lanes
/// are known is judged, and every valid indicator in it. An unpainted edge has no line that could be measured: there the lane ends where
/// the layout ends it, one lane from its other boundary.
/// </summary>
internal sealed class LaneJudge
{
    /// <summary>Paint that crosses a road at more than 30 degrees belongs to another one.</summary>
    private const double MinAlong = 0.87;

    /// <summary>Paint of a bridge above or below lies farther away than this, metres.</summary>
    private const double SameLevel = 3;

    /// <summary>Edge lines lie up to a fifth of the lane's width inside the edge; the rest is for the roads' facets.</summary>
    private const double MaxInset = 0.2;
    private const double FacetMetres = 0.1;

    /// <summary>The error of an indicator that says that a boundary exists where there is none, metres: half a narrow lane.</summary>
    private const double Absent = 1.5;

    /// <summary>A measured line is that of a boundary up to this distance, metres: half of a double line.</summary>
    private const double SameLine = 0.3;

    private const double Cell = 20;
    private const double WalkStep = 0.5;

    private readonly List<(double Error, LaneWidthSource? Source)> _metres = [];
    private readonly List<(double Error, LaneWidthSource? Source)> _angles = [];
    private SimulatedGame _game = null!;
    private ILookup<(int X, int Y), (Vector3D From, Vector3D To)> _paint = null!;
    private ILookup<(int X, int Y), (Vector3D From, Vector3D To)> _measured = null!;
    private readonly SortedDictionary<string, int> _sources = [];
    private readonly SortedDictionary<string, int> _edges = [];

    public int Frames { get; private set; }

    /// <summary>Frames with known lanes where the game has none: in junctions and beside the lanes.</summary>
    public int Elsewhere { get; private set; }

    public List<string> Faults { get; } = [];

    /// <summary>Judges the following frames by another game.</summary>
    public void Enter(SimulatedGame game, IEnumerable<PaintedLine> painted, IEnumerable<PaintedLine> measured)
    {
        _game = game;
        _paint = Segments(painted);
        _measured = Segments(measured);
    }

    public void Judge(FrameLabel label, EgoState ego)
    {
        if (label.Lanes is not { Status: LaneStatus.Known } lanes)
        {
            return;
        }

        Frames++;
        Count(_sources, $"{lanes.LaneWidthSource}");
        Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
        Vector3D forward = ego.Pose.Axes.Forward;
        if (_game.Truth.Locate(centre, forward) is not { Lane: not null, IsInJunction: false } here)
        {
            Elsewhere++;
            return;
        }

        Count(_edges, EdgesAt(centre, forward, here));
        string frame = FormattableString.Invariant($"frame {label.Frame} at {centre.X:0},{centre.Y:0} ({lanes.LaneWidthSource})");
        Compare(lanes.IndicatorsAtCar, lanes, Offsets(BoundariesAt(centre, forward, here)), here.AngleToRoad, frame);
        if (Walked(centre, forward, here, lanes.LookAheadMetres) is { } there)
        {
            double moved = there.At.RightOfRoadLine - here.RightOfRoadLine;
            double[] boundaries = [.. BoundariesAt(there.Place, forward, there.At).Select(boundary => boundary.Offset + moved)];
            Compare(lanes.Indicators, lanes, boundaries, there.At.AngleToRoad, frame + " ahead");
        }
    }

    public string Text(bool onlyPaint) =>
        FormattableString.Invariant($"{Frames} frames ({Shares(_sources)}), {Elsewhere} elsewhere; ")
        + FormattableString.Invariant($"markings {Metres(0.5, onlyPaint):0.000} m median, {Metres(0.95, onlyPaint):0.000} m 95 %; ")
        + FormattableString.Invariant($"angle {Angle(0.5, onlyPaint):0.0000} rad median, {Angle(0.95, onlyPaint):0.0000} rad 95 %");

    /// <summary>The outer edges of the car's direction beside the car, by frames.</summary>
    public string Edges => Shares(_edges);

    public double Metres(double share, bool onlyPaint) => Quantile(_metres, share, onlyPaint);

    public double Angle(double share, bool onlyPaint) => Quantile(_angles, share, onlyPaint);

    private void Compare(LaneIndicators labelled, LanesLabel lanes, double[] boundaries, double angle, string frame)
    {
        double turned = Math.Abs(Angles.WrapRadians(labelled.Angle.Value - angle));
        _angles.Add((turned, lanes.LaneWidthSource));
        if (turned > 0.01)
        {
            Faults.Add(FormattableString.Invariant($"{frame}: angle off by {turned:0.0000}"));
        }

        // The lane between boundaries on either side of the car, and the boundary nearest to it.
        int lane = Math.Clamp(Array.FindLastIndex(boundaries, offset => offset <= 0), 0, boundaries.Length - 2);
        int nearest = Enumerable.Range(0, boundaries.Length).MinBy(i => Math.Abs(boundaries[i]));
        Compare("LL", labelled.ToMarkingLL, lane - 1);
        Compare("ML", labelled.ToMarkingML, lane);
        Compare("MR", labelled.ToMarkingMR, lane + 1);
        Compare("RR", labelled.ToMarkingRR, lane + 2);
        Compare("L", labelled.ToMarkingL, nearest - 1);
        Compare("M", labelled.ToMarkingM, nearest);
        Compare("R", labelled.ToMarkingR, nearest + 1);

        void Compare(string name, Indicator indicator, int boundary)
        {
            if (!indicator.IsValid)
            {
                return;
            }

            bool exists = boundary >= 0 && boundary < boundaries.Length;
            double error = exists ? Math.Abs(indicator.Value - boundaries[boundary]) : Absent;
            _metres.Add((error, lanes.LaneWidthSource));
            if (error > 0.1)
            {
                string list = string.Join(' ', boundaries.Select(offset => FormattableString.Invariant($"{offset:0.00}")));
                Faults.Add(FormattableString.Invariant($"{frame}: {name} {indicator.Value:0.00}, off by {error:0.00}; true {list}"));
            }
        }
    }

    private string EdgesAt(Vector3D centre, Vector3D forward, LanePosition here)
    {
        (double Offset, bool IsPainted)[] boundaries = BoundariesAt(centre, forward, here);
        double[] measured = [.. Crossings(_measured, centre, Along(forward, here))];
        bool IsMeasured(double offset) => Array.Exists(measured, line => Math.Abs(line - offset) <= SameLine);
        (double Offset, bool IsPainted)[] outer = [boundaries[0], boundaries[^1]];
        return !Array.TrueForAll(outer, edge => edge.IsPainted) ? "an edge is not painted"
            : Array.TrueForAll(outer, edge => IsMeasured(edge.Offset)) ? "both measured"
            : "painted, not measured";
    }

    /// <summary>Direction of the road on the ground.</summary>
    private static Vector2D Along(Vector3D forward, LanePosition at)
    {
        double sin = Math.Sin(at.AngleToRoad);
        double cos = Math.Cos(at.AngleToRoad);
        double length = Math.Sqrt((forward.X * forward.X) + (forward.Y * forward.Y));
        return new Vector2D(((forward.X * cos) - (forward.Y * sin)) / length, ((forward.X * sin) + (forward.Y * cos)) / length);
    }

    private static double[] Offsets((double Offset, bool IsPainted)[] boundaries) => [.. boundaries.Select(boundary => boundary.Offset)];

    /// <summary>The true boundaries of the lanes of the car's direction, metres to the right of a place.</summary>
    private (double Offset, bool IsPainted)[] BoundariesAt(Vector3D place, Vector3D forward, LanePosition at)
    {
        double[] painted = [.. Crossings(_paint, place, Along(forward, at))];
        double inset = (MaxInset * at.LaneWidth) + FacetMetres;
        return
        [
            .. Enumerable
                .Range(0, at.Lanes + 1)
                .Select(i => ((i - at.Lane!.Value - 0.5) * at.LaneWidth) - at.RightOfLaneCentre)
                .Select(edge =>
                    painted
                        .Where(offset => Math.Abs(offset - edge) <= inset)
                        .OrderBy(offset => Math.Abs(offset - edge))
                        .Select(offset => (offset, true))
                        .DefaultIfEmpty((edge, false))
                        .First()
                ),
        ];
    }

    /// <summary>Where painted lines cross the straight line across the road, metres to the right of a place.</summary>
    private static IEnumerable<double> Crossings(
        ILookup<(int X, int Y), (Vector3D From, Vector3D To)> lines,
        Vector3D place,
        Vector2D along
    )
    {
        (int x, int y) = CellOf(place);
        for (int i = 0; i < 25; i++)
        {
            foreach ((Vector3D from, Vector3D to) in lines[(x + (i % 5) - 2, y + (i / 5) - 2)])
            {
                var segment = new Vector2D(to.X - from.X, to.Y - from.Y);
                var start = new Vector2D(from.X - place.X, from.Y - place.Y);
                double before = start.Dot(along);
                double after = before + segment.Dot(along);
                if (
                    Math.Abs(from.Z - place.Z) <= SameLevel
                    && Math.Abs(segment.Dot(along)) >= MinAlong * segment.Length
                    && (before <= 0) != (after <= 0)
                )
                {
                    Vector2D crossing = start + (segment * (before / (before - after)));
                    yield return -along.Cross(crossing);
                }
            }
        }
    }

    /// <summary>The place a distance ahead along the road; null where another road or a junction begins before.</summary>
    private (Vector3D Place, LanePosition At)? Walked(Vector3D place, Vector3D forward, LanePosition from, double distance)
    {
        LanePosition at = from;
        for (double walked = 0; walked < distance - 1e-6; walked = Math.Abs(at.DistanceAlongRoad - from.DistanceAlongRoad))
        {
            double step = Math.Min(WalkStep, distance - walked);
            double sin = Math.Sin(at.AngleToRoad);
            double cos = Math.Cos(at.AngleToRoad);
            var flat = new Vector2D(forward.X, forward.Y);
            flat *= 1 / flat.Length;
            place += new Vector3D((flat.X * cos) - (flat.Y * sin), (flat.X * sin) + (flat.Y * cos), 0) * step;
            if (
                _game.Truth.Locate(place, forward) is not { Lane: not null, IsInJunction: false } next
                || next.Road != from.Road
                || Math.Abs(next.DistanceAlongRoad - from.DistanceAlongRoad) <= walked
            )
            {
                return null;
            }

            at = next;
        }

        return (place, at);
    }

    private static double Quantile(List<(double Error, LaneWidthSource? Source)> errors, double share, bool onlyPaint)
    {
        double[] sorted = [.. errors.Where(e => !onlyPaint || e.Source == LaneWidthSource.Paint).Select(e => e.Error).Order()];
        return sorted.Length == 0 ? double.NaN : sorted[(int)(share * (sorted.Length - 1))];
    }

    private static ILookup<(int X, int Y), (Vector3D From, Vector3D To)> Segments(IEnumerable<PaintedLine> lines) =>
        lines
            .SelectMany(line => Enumerable.Range(0, line.Points.Count - 1).Select(i => (line.Points[i].World, line.Points[i + 1].World)))
            .ToLookup(segment => CellOf(segment.Item1));

    private static void Count(SortedDictionary<string, int> counts, string key) => counts[key] = counts.GetValueOrDefault(key) + 1;

    private static string Shares(SortedDictionary<string, int> counts) =>
        string.Join(", ", counts.Select(count => $"{count.Key} {100.0 * count.Value / counts.Values.Sum():0} %"));

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X / Cell), (int)Math.Floor(place.Y / Cell));
}
