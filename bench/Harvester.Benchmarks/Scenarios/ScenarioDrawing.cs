using Harvester.Driving.Scenarios;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Pages;

namespace Harvester.Benchmarks.Scenarios;

/// <summary>Draws a scenario from above, the ego driving to the right.</summary>
/// <param name="bound">The scenario at its place.</param>
/// <param name="bodies">The bodies in all moments, in their order.</param>
internal sealed class ScenarioDrawing(BoundScenario bound, IReadOnlyList<DrawnBody> bodies)
{
    private const double PixelsPerMetre = 4;
    private const int Width = 440;
    private const int Height = 160;

    /// <summary>Metres shown behind the ego's start, and in which lanes are looked for around the middle.</summary>
    private const double Behind = 22;
    private const double Reach = 75;

    /// <summary>Seconds between two outlines of a body, and opacity of all but the last and first.</summary>
    private const double Interval = 1;
    private const double Faint = 0.25;

    /// <summary>A body that has moved less is not drawn again, metres.</summary>
    private const double PathStep = 1;

    /// <summary>How far a line may be from the true one, pixels.</summary>
    private const double Tolerance = 0.5;

    private static readonly string[] Colours = ["#d64519", "#7a3ea8", "#0a7f5a", "#b58a00", "#8a4b2a", "#c2185b"];

    /// <summary>Whether the ego's way does not leave the picture at its upper or lower edge.</summary>
    public bool ShowsEgo => bodies.Where(body => body.Id is null).All(body => InPicture(body.Middle).Y is > 0 and < Height);

    /// <summary>Writes the picture.</summary>
    public void Write(Stream stream) =>
        SvgImage.Write(
            stream,
            Width,
            Height,
            svg =>
            {
                WriteLanes(svg);
                WriteBodies(svg);
            }
        );

    private void WriteLanes(MarkupWriter svg)
    {
        LaneTrack track = bound.Place.Track;
        MapLane[] lanes =
        [
            .. bound
                .Place.Map.Index.Near(track.PositionAt((Width / PixelsPerMetre / 2) - Behind), Reach)
                .Where(lane => lane.Centre.Any(point => IsInPicture(InPicture(new Vector2D(point.X, point.Y))))),
        ];
        foreach (MapLane lane in lanes)
        {
            svg.Start("polygon").WithPoints(Line(lane.Left).Concat(Line(lane.Right.Reverse()))).With("fill", "#dcdcdc").End().NewLine();
        }

        svg.Start("path").With("fill", "none").With("stroke", "#ffffff").With("stroke-width", 1);
        svg.WithLines(lanes.Where(lane => lane.Junction is null).SelectMany(lane => (Vector2D[][])[Line(lane.Left), Line(lane.Right)]))
            .End()
            .NewLine();
    }

    private void WriteBodies(MarkupWriter svg)
    {
        string?[] ids = [.. bodies.Select(body => body.Id).Distinct()];
        foreach (string? id in ids)
        {
            DrawnBody[] own = [.. bodies.Where(body => body.Id == id)];
            string colour = id is null ? "#1f5fbf" : Colours[(Array.IndexOf(ids, id) - 1) % Colours.Length];
            svg.Start("path").With("fill", "none").With("stroke", colour).With("stroke-width", 1).With("stroke-dasharray", "3 2");
            svg.WithLines([PathOf(own)]).End().NewLine();
            foreach ((int index, DrawnBody body) in Shown(own).Index())
            {
                svg.Start("polygon").WithPoints(body.Corners.Select(InPicture)).With("fill", colour);
                svg.With("fill-opacity", index == 0 ? 1 : Faint, 2).With("stroke", colour).With("stroke-width", 0.5).End().NewLine();
            }
        }
    }

    /// <summary>The first moment, and those in which the body has moved since the last one shown, an interval apart.</summary>
    private static IEnumerable<DrawnBody> Shown(DrawnBody[] own)
    {
        DrawnBody last = own[0];
        yield return last;
        foreach (DrawnBody body in own)
        {
            if (body.Seconds - last.Seconds >= Interval && (body.Middle - last.Middle).Length > PathStep)
            {
                last = body;
                yield return last;
            }
        }
    }

    private Vector2D[] PathOf(DrawnBody[] own) => Simplified([.. own.Select(body => InPicture(body.Middle))]);

    private Vector2D[] Line(IEnumerable<Vector3D> line) => Simplified([.. line.Select(point => InPicture(new Vector2D(point.X, point.Y)))]);

    /// <summary>
    /// A line without the points that lie within a tolerance of it: the farthest from the chord is kept, and both parts likewise
    /// (Douglas and Peucker 1973).
    /// </summary>
    private static Vector2D[] Simplified(Vector2D[] line)
    {
        if (line.Length < 3)
        {
            return line;
        }

        int farthest = Enumerable.Range(1, line.Length - 2).MaxBy(i => FromChord(line, i));
        return FromChord(line, farthest) <= Tolerance
            ? [line[0], line[^1]]
            : [.. Simplified(line[..(farthest + 1)]), .. Simplified(line[farthest..]).Skip(1)];
    }

    private static double FromChord(Vector2D[] line, int i)
    {
        Vector2D chord = line[^1] - line[0];
        Vector2D place = line[i] - line[0];
        return chord.Length > 0 ? Math.Abs(chord.Cross(place)) / chord.Length : place.Length;
    }

    private static bool IsInPicture(Vector2D place) => place.X is >= 0 and <= Width && place.Y is >= 0 and <= Height;

    /// <summary>Metres ahead of the ego's start to the right, metres to its left upwards.</summary>
    private Vector2D InPicture(Vector2D place)
    {
        LaneTrack track = bound.Place.Track;
        Vector3D start = track.PositionAt(0);
        Vector3D forward = track.DirectionAt(0);
        (double x, double y) = (place.X - start.X, place.Y - start.Y);
        double ahead = (x * forward.X) + (y * forward.Y);
        double right = (x * forward.Y) - (y * forward.X);
        return new Vector2D((ahead + Behind) * PixelsPerMetre, (Height / 2.0) + (right * PixelsPerMetre));
    }
}
