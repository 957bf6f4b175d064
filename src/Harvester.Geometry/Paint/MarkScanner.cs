namespace Harvester.Geometry.Paint;

/// <summary>
/// Looks for stop lines, crossings and arrows in images. Around each image the ground in the mouths of junctions is unrolled twice: in
/// columns along the road for stop lines, and in rows across it for crossings and arrows.
/// </summary>
/// <param name="mouths">Where to look.</param>
/// <param name="profile">Receives the profiles.</param>
internal sealed class MarkScanner(JunctionMouths mouths, GroundProfile profile)
{
    /// <summary>
    /// Farthest ground, metres from the camera: from 1.5 m above, an error of its height by 2 cm moves it by 0.2 m along the road. From
    /// higher up, it may be as far away as the camera is high.
    /// </summary>
    public const double MaxDistance = 15;

    /// <summary>A camera whose axis points down by more than 45 degrees looks at the road from above.</summary>
    private const double Downwards = -0.7;

    /// <summary>Longest pixel along the road, metres: two of them are the width of a stop line.</summary>
    private const double MaxPixelAlong = 0.25;

    /// <summary>Standard deviation of the position of an edge, pixels.</summary>
    private const double EdgeSigma = 0.3;

    /// <summary>Step in which the part of a mouth in view is found, metres.</summary>
    private const double ViewStep = 0.5;

    /// <summary>Step in which the carriageway's reach is found, metres.</summary>
    private const double ReachStep = 2;

    private readonly StopLineFinder _stopLines = new();
    private readonly CrossingFinder _crossings = new();
    private readonly ArrowFinder _arrows = new();

    /// <summary>Scans an image.</summary>
    /// <param name="image">The image.</param>
    /// <param name="number">Number of the image.</param>
    /// <param name="evidence">Receives what is seen.</param>
    public void Scan(PaintImage image, int number, MarkEvidence evidence)
    {
        profile.DepthTolerance = GroundProfile.MaxDepthTolerance;
        for (int i = 0; i < mouths.All.Count; i++)
        {
            JunctionMouth mouth = mouths.All[i];
            double limit = LimitAt(image, mouth);
            if (DistanceFrom(image, mouth.Node) > limit + mouth.Length)
            {
                continue;
            }

            profile.MaxDepth = IsFromAbove(image) ? double.PositiveInfinity : limit;
            if (InView(image, mouth, limit) is { } range)
            {
                Scan(image, number, i, range.From, range.To, evidence);
            }
        }

        profile.MaxDepth = double.PositiveInfinity;
    }

    private static bool IsFromAbove(PaintImage image) => image.Camera.Pose.Axes.Forward.Z < Downwards;

    private static double DistanceFrom(PaintImage image, Vector3D place)
    {
        Vector3D camera = image.Camera.Pose.Position;
        return new Vector2D(place.X - camera.X, place.Y - camera.Y).Length;
    }

    /// <summary>The first and last distance at which the middle or a side of the road is near enough; null if none is.</summary>
    private static (double From, double To)? InView(PaintImage image, JunctionMouth mouth, double limit)
    {
        double from = double.NaN;
        double to = double.NaN;
        for (double distance = 0; distance <= mouth.Length; distance += ViewStep)
        {
            (double left, double right) = mouth.ReachAt(distance);
            Func<double, Vector3D> across = mouth.Across(distance);
            if (IsInView(0) || IsInView(left) || IsInView(right))
            {
                from = double.IsNaN(from) ? distance : from;
                to = distance;
            }

            bool IsInView(double offset)
            {
                Vector3D place = across(offset);
                return image.Camera.Pose.ToLocal(place).Y > 0 && DistanceFrom(image, place) <= limit;
            }
        }

        return to > from ? (from, to) : null;
    }

    /// <summary>
    /// The distance up to which a pixel is short enough along the road: (d² + h²) / (f h) = its length, with the focal length f in pixels
    /// and the camera's height h above the road; 0 if the camera is below it, or too high.
    /// </summary>
    private static double LimitAt(PaintImage image, JunctionMouth mouth)
    {
        double height = image.Camera.Pose.Position.Z - mouth.PlaceAt(mouth.Length, 0).Z;
        double square = (MaxPixelAlong * image.Camera.Intrinsics.Fx * height) - (height * height);
        return height > 0 && square > 0 ? Math.Min(Math.Max(MaxDistance, height), Math.Sqrt(square)) : 0;
    }

    /// <summary>Length of a pixel along the line of sight on the ground, metres: (d² + h²) / (f h), with the focal length f in pixels, the
    /// camera's height h and the distance d on the ground.</summary>
    private static double PixelAlong(PaintImage image, Vector3D place)
    {
        double distance = DistanceFrom(image, place);
        double height = image.Camera.Pose.Position.Z - place.Z;
        return height > 0 ? ((distance * distance) + (height * height)) / (image.Camera.Intrinsics.Fx * height) : double.PositiveInfinity;
    }

    private void Scan(PaintImage image, int number, int index, double from, double to, MarkEvidence evidence)
    {
        JunctionMouth mouth = mouths.All[index];
        (double left, double right) = (0, 0);
        var reaches = new List<(double Left, double Right)>();
        for (double distance = from; distance <= to; distance += ReachStep)
        {
            reaches.Add(mouth.ReachAt(distance));
            left = Math.Min(left, reaches[reaches.Count - 1].Left);
            right = Math.Max(right, reaches[reaches.Count - 1].Right);
        }

        var seen = new List<(float From, float To)>();
        var view = new MouthView(number, left, seen) { IsFromAbove = IsFromAbove(image) };
        _stopLines.Clear();
        for (int column = 0; view.OffsetOf(column) < right; column++)
        {
            seen.Add(ScanColumn(image, mouth, column, view.OffsetOf(column), from, to, reaches));
        }

        _crossings.Clear();
        _arrows.Clear();
        for (int row = 0; from + (row * CrossingFinder.RowStep) <= to; row++)
        {
            ScanRow(image, mouth, row, from + (row * CrossingFinder.RowStep));
        }

        if (seen.Exists(static column => column.To > column.From))
        {
            double SigmaAt(double distance)
            {
                // σ² = e² + (σz d / h)², with e the error of an edge and σz that of the height of the ground.
                Vector3D place = mouth.PlaceAt(distance, 0);
                double away = DistanceFrom(image, place);
                double edge = EdgeSigma * PixelAlong(image, place);
                double lift = image.Ground.SigmaAt(away) * away / Math.Max(0.1, image.Camera.Pose.Position.Z - place.Z);
                return Math.Sqrt((edge * edge) + (lift * lift));
            }

            evidence.Add(
                index,
                view,
                [.. _stopLines.Find(view, SigmaAt), .. _crossings.Find(view, from, SigmaAt), .. _arrows.Find(view, from, SigmaAt)]
            );
        }
    }

    /// <summary>Scans a column where the carriageway reaches as far as it.</summary>
    /// <returns>The longest part that was seen; NaN for none.</returns>
    private (float From, float To) ScanColumn(
        PaintImage image,
        JunctionMouth mouth,
        int column,
        double offset,
        double from,
        double to,
        List<(double Left, double Right)> reaches
    )
    {
        int first = reaches.FindIndex(reach => offset >= reach.Left && offset <= reach.Right);
        int last = reaches.FindLastIndex(reach => offset >= reach.Left && offset <= reach.Right);
        if (first < 0)
        {
            return (float.NaN, float.NaN);
        }

        double begin = from + (first * ReachStep);
        int cells = (int)((Math.Min(to, from + ((last + 1) * ReachStep)) - begin) / StripeFinder.Cell);
        profile.Clear(cells);
        profile.Add(image, distance => mouth.PlaceAt(distance, offset), begin, cells);
        (int Begin, int End) longest = default;
        (int Begin, int End) run = profile.NextSeen(0, cells, 1);
        while (run.Begin < run.End)
        {
            _stopLines.Add(column, profile, begin, run.Begin, run.End);
            longest = run.End - run.Begin > longest.End - longest.Begin ? run : longest;
            run = profile.NextSeen(run.End, cells, 1);
        }

        return longest.End > longest.Begin
            ? ((float)(begin + (longest.Begin * StripeFinder.Cell)), (float)(begin + (longest.End * StripeFinder.Cell)))
            : (float.NaN, float.NaN);
    }

    private void ScanRow(PaintImage image, JunctionMouth mouth, int row, double distance)
    {
        (double left, double right) = mouth.ReachAt(distance);
        int cells = (int)((right - left) / StripeFinder.Cell);
        profile.Clear(cells);
        profile.Add(image, mouth.Across(distance), left, cells);
        (int Begin, int End) run = profile.NextSeen(0, cells, 1);
        while (run.Begin < run.End)
        {
            _crossings.Add(row, profile, left, run.Begin, run.End);
            _arrows.Add(row, profile, left, run.Begin, run.End);
            run = profile.NextSeen(run.End, cells, 1);
        }
    }
}
