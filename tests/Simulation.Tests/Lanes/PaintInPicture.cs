using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>
/// Finds the stripe of a marking in a picture at noon in clear weather, where paint is far brighter than asphalt and yellow has little
/// blue. It is looked for across the line as it lies on the ground, where it crosses the labelled pixel: the ends of dashes run that way,
/// too.
/// </summary>
internal sealed class PaintInPicture(RenderTarget picture, CameraState camera)
{
    /// <summary>How far to either side of a line's width paint is looked for, pixels of the picture.</summary>
    private const int Beside = 48;

    /// <summary>A stripe that is thinner in the picture fades into the asphalt, pixels.</summary>
    private const double Thinnest = 2;

    /// <summary>A line that is seen at a smaller angle to the cut is cut at a slant: its sine, of 6 degrees.</summary>
    private const double MinSine = 0.1;

    /// <summary>
    /// At noon asphalt is darker than this, of 255; what is brighter all along a cut is paint that runs along the cut, as a stop line's.
    /// </summary>
    private const double BrightestAsphalt = 140;

    /// <summary>
    /// A picture tells where paint begins or ends to this, pixels: where a cut so far beyond meets paint, it may end at the place.
    /// </summary>
    private const double EndPixels = 1;

    /// <summary>Paint differs from the asphalt around by at least this, of 255.</summary>
    private const double MinContrast = 25;

    /// <summary>
    /// Stripes are this near to their width, as a fraction of it and pixels for their edges; others are cut, or run into other paint.
    /// </summary>
    private const double WidthFraction = 0.25;
    private const double WidthPixels = 2;

    /// <summary>What rises above the road by more stands before it, metres and per metre beside the line: roads are level across.</summary>
    private const double Rise = 0.03;
    private const double RisePerMetre = 0.1;

    /// <summary>Paint further beside the labelled line is another line's, metres: lines of a road are four metres apart and more.</summary>
    private const double MaxLateralDistance = 1;

    private readonly double _focalY = picture.Height / (2 * Math.Tan(camera.VerticalFovDegrees * Math.PI / 360));

    private double FocalX => _focalY * picture.Width / (picture.Height * camera.WindowAspect);

    public PaintFinding Find(WrittenMarking line, int i, int fineness)
    {
        Vector3D along = line.Along(i);
        Vector3D across = new Vector3D(along.Y, -along.X, 0) * (line.WidthMetres / 2);
        Vector2D width = Pixel(line.Point(i) + across) - Pixel(line.Point(i) - across);
        Vector2D direction = Pixel(line.Point(i) + (along * 0.05)) - Pixel(line.Point(i) - (along * 0.05));
        double expected = width.Length;
        double squareToLine = Math.Abs(width.Cross(direction)) / (width.Length * direction.Length);
        double thickness = expected * squareToLine;
        if ((line.IsDouble ? thickness / 3 : thickness) < Thinnest || squareToLine < MinSine)
        {
            return new PaintFinding(PaintFindingKind.NotMeasurable);
        }

        PaintFinding At(double pixelsBeyond) =>
            Cut(
                (line.Pixel(i) * fineness) + (direction * (pixelsBeyond / (squareToLine * direction.Length))),
                width * (1 / expected),
                expected,
                line.Point(i),
                along,
                line.IsYellow
            )
                is { } cut
                ? Nearest(cut, line.IsDouble, expected, squareToLine)
                : new PaintFinding(PaintFindingKind.NotMeasurable);

        PaintFinding found = At(0);
        return
            found.Kind == PaintFindingKind.NoPaint
            && (At(EndPixels).Kind != PaintFindingKind.NoPaint || At(-EndPixels).Kind != PaintFindingKind.NoPaint)
            ? new PaintFinding(PaintFindingKind.NotMeasurable)
            : found;
    }

    /// <summary>
    /// How much brighter or yellower than the ground around the pixels of a cut are; null where something stands before its middle, its
    /// middle is not in the picture, or it lies in other paint.
    /// </summary>
    private double[]? Cut(Vector2D at, Vector2D direction, double width, Vector3D ground, Vector3D along, bool isYellow)
    {
        double middle = width + WidthPixels;
        int reach = (int)width + Beside;
        double[] cut = new double[(2 * reach) + 1];
        bool[] isBeside = new bool[cut.Length];
        List<double> grounds = [];
        for (int t = -reach; t <= reach; t++)
        {
            Vector2D place = at + (direction * t);
            (int column, int row) = ((int)Math.Floor(place.X), (int)Math.Floor(place.Y));
            bool isInside = column >= 0 && row >= 0 && column < picture.Width && row < picture.Height;
            Vector3D? seen = isInside ? Seen(column, row) : null;
            if (seen is { } there && IsGround(there, ground))
            {
                int index = ((row * picture.Width) + column) * 3;
                (byte red, byte green, byte blue) = (picture.Colour[index], picture.Colour[index + 1], picture.Colour[index + 2]);
                cut[t + reach] = isYellow ? Math.Min(red, green) - blue : Math.Min(red, Math.Min(green, blue));
                grounds.Add(cut[t + reach]);
                isBeside[t + reach] = Math.Abs(((there.X - ground.X) * along.Y) - ((there.Y - ground.Y) * along.X)) <= MaxLateralDistance;
            }
            else if (Math.Abs(t) <= middle)
            {
                return null;
            }
            else
            {
                cut[t + reach] = double.NegativeInfinity;
            }
        }

        // Most of a cut may be paint where the line turns, and most of it may be brighter ground.
        double asphalt = grounds.Order().ElementAt(grounds.Count / 4);
        return asphalt > BrightestAsphalt ? null : [.. cut.Select((value, t) => isBeside[t] ? Math.Max(0, value - asphalt) : 0)];
    }

    /// <summary>The stripe, or the pair of stripes, that is nearest to the middle of a cut.</summary>
    private static PaintFinding Nearest(double[] cut, bool isDouble, double expected, double squareToLine)
    {
        List<(int From, int To)> runs = Runs(cut);
        if (runs.Count == 0)
        {
            return new PaintFinding(PaintFindingKind.NoPaint);
        }

        // From afar two stripes are one.
        IEnumerable<(int From, int To)> stripes = isDouble
            ? runs.Concat(runs.Zip(runs.Skip(1), (left, right) => (left.From, right.To)))
            : runs;
        (int From, int To) nearest = stripes.MinBy(run => Math.Abs(Middle(run, cut)));
        return Math.Abs(nearest.To - nearest.From - expected) <= (WidthFraction * expected) + WidthPixels
            ? new PaintFinding(PaintFindingKind.Paint, Middle(nearest, cut) * squareToLine)
            : new PaintFinding(PaintFindingKind.NotMeasurable);
    }

    private static List<(int From, int To)> Runs(double[] cut)
    {
        List<(int From, int To)> runs = [];
        for (int i = 0; i < cut.Length; i++)
        {
            int from = i;
            while (i < cut.Length && cut[i] >= MinContrast)
            {
                i++;
            }

            if (i > from)
            {
                runs.Add((from, i));
            }
        }

        return runs;
    }

    /// <summary>From the middle of a cut to that of a run.</summary>
    private static double Middle((int From, int To) run, double[] cut) => (run.From + run.To - cut.Length) / 2.0;

    private static bool IsGround(Vector3D seen, Vector3D near)
    {
        Vector3D apart = seen - near;
        return apart.Z < Rise + (RisePerMetre * Math.Sqrt((apart.X * apart.X) + (apart.Y * apart.Y)));
    }

    /// <summary>The place of the world that a pixel shows; null where it shows an entity or the sky.</summary>
    private Vector3D? Seen(int column, int row)
    {
        int index = (row * picture.Width) + column;
        double depth = picture.Depth[index];
        return picture.Handles[index] != 0 || double.IsInfinity(depth)
            ? null
            : camera.Pose.ToWorld(
                new Vector3D(
                    (column + 0.5 - (picture.Width / 2.0)) / FocalX * depth,
                    depth,
                    ((picture.Height / 2.0) - row - 0.5) / _focalY * depth
                )
            );
    }

    /// <summary>A point of the world in the picture, by the camera that it was drawn with.</summary>
    private Vector2D Pixel(Vector3D world)
    {
        Vector3D local = camera.Pose.ToLocal(world);
        return new Vector2D((picture.Width / 2.0) + (FocalX * local.X / local.Y), (picture.Height / 2.0) - (_focalY * local.Z / local.Y));
    }
}
