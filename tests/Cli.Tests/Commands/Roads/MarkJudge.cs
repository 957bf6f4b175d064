using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>Compares the marks of one kind in a table with those that the simulated game painted.</summary>
internal sealed class MarkJudge(MarkKind kind, double maxDistance = MarkJudge.OfDrives)
{
    /// <summary>
    /// A mark is in view if the images together show this share of its area from no farther than this, metres: nearer than the 15 m up to
    /// which marks are searched, because there a stop line is two pixels high. What vehicles hide counts as in view.
    /// </summary>
    private const double MinShare = 0.8;
    public const double OfDrives = 12;

    /// <summary>The distance from above: from the camera, 33.8 m up, to the corner of its picture.</summary>
    public const double FromAbove = 46;

    /// <summary>Points along and across a mark that are looked at.</summary>
    private const int Grid = 8;

    /// <summary>A measured mark belongs to a painted one if its middle lies in the outline of that, or this near to it, metres: the width
    /// of the bar of a stop line.</summary>
    private const double MaxApart = 0.5;

    private readonly List<double> _along = [];
    private readonly List<double> _covered = [];

    public int Visible { get; private set; }

    public int Measured { get; private set; }

    /// <summary>Measured marks whose middle lies on no painted one.</summary>
    public int False { get; private set; }

    public double AlongMedian => Quantile(_along, 0.5);

    public double Along95 => Quantile(_along, 0.95);

    public int VisibleFound { get; private set; }

    public List<string> Faults { get; } = [];

    /// <summary>Adds a table, what is painted on its roads, and the session in which it was measured.</summary>
    public void Judge(PaintTable table, IReadOnlyList<PaintedMark> painted, SessionReader session)
    {
        List<Box> truths = [.. painted.Where(mark => mark.Kind == kind).Select(Box.Of)];
        var found = new HashSet<Box>();
        foreach (MarkPaint mark in table.Marks.Where(mark => mark.Mark.Kind == kind))
        {
            Box measured = Box.Of(mark.Mark);
            if (truths.Find(truth => truth.Contains(measured.Middle)) is { } truth)
            {
                found.Add(truth);
                _along.Add(truth.ErrorAlong(mark.Mark));
                _covered.Add(truth.ShareCoveredBy(mark.Mark));
            }
            else
            {
                False++;
                Faults.Add(
                    FormattableString.Invariant($"{kind} at {measured.Middle.X:0.0}, {measured.Middle.Y:0.0}, {measured.Size}, ")
                        + FormattableString.Invariant($"of {mark.Images} images is not painted")
                );
            }
        }

        Measured += table.Marks.Count(mark => mark.Mark.Kind == kind);
        List<Camera> cameras = [.. session.ReadLabels().Select(label => LabelCamera.Of(label.Camera))];
        foreach (Box truth in truths.Where(truth => truth.ShareSeenBy(cameras, maxDistance) >= MinShare))
        {
            Visible++;
            VisibleFound += found.Contains(truth) ? 1 : 0;
            if (!found.Contains(truth))
            {
                Faults.Add(FormattableString.Invariant($"{kind} at {truth.Middle.X:0.0}, {truth.Middle.Y:0.0}, {truth.Size}, is missing"));
            }
        }
    }

    public override string ToString() =>
        FormattableString.Invariant(
            $"{kind}: {VisibleFound} of {Visible} in view found, {Measured} measured, {False} false; along the road "
        )
        + FormattableString.Invariant($"{100 * AlongMedian:0.0} cm median, {100 * Along95:0.0} cm 95 %; ")
        + FormattableString.Invariant($"of the width {100 * _covered.DefaultIfEmpty().Average():0} % on average");

    private static double Quantile(List<double> values, double share) =>
        values.Count == 0 ? double.NaN : values.Order().ElementAt((int)(share * (values.Count - 1)));

    /// <summary>A rectangle on the ground.</summary>
    /// <param name="Corners">Its corners.</param>
    /// <param name="Along">Unit vector along the road.</param>
    private sealed record Box(IReadOnlyList<Vector3D> Corners, Vector2D Along)
    {
        public static Box Of(PaintedMark mark)
        {
            Vector3D side = mark.Corners[2] + mark.Corners[3] - mark.Corners[0] - mark.Corners[1];
            var along = new Vector2D(side.X, side.Y);
            return new Box(mark.Corners, along * (1 / along.Length));
        }

        public Vector3D Middle => (Corners[0] + Corners[1] + Corners[2] + Corners[3]) / 4;

        public string Size =>
            FormattableString.Invariant($"{Span(Corners, Along).To - Span(Corners, Along).From:0.0} x ")
            + FormattableString.Invariant($"{Span(Corners, Across).To - Span(Corners, Across).From:0.0} m");

        private Vector2D Across => new(Along.Y, -Along.X);

        public bool Contains(Vector3D place) => IsWithin(place, Along) && IsWithin(place, Across);

        /// <summary>The mean error of the two edges along the road, metres.</summary>
        public double ErrorAlong(PaintedMark mark)
        {
            (double from, double to) = Span(Corners, Along);
            (double measuredFrom, double measuredTo) = Span(mark.Corners, Along);
            return (Math.Abs(measuredFrom - from) + Math.Abs(measuredTo - to)) / 2;
        }

        /// <summary>The share of its width that a measured mark covers; what it covers beyond the ends is subtracted.</summary>
        public double ShareCoveredBy(PaintedMark mark)
        {
            (double from, double to) = Span(Corners, Across);
            (double measuredFrom, double measuredTo) = Span(mark.Corners, Across);
            double common = Math.Min(to, measuredTo) - Math.Max(from, measuredFrom);
            return (common - (measuredTo - measuredFrom - common)) / (to - from);
        }

        /// <summary>The share of its area that is in one of the images and near enough to its camera.</summary>
        public double ShareSeenBy(List<Camera> cameras, double maxDistance)
        {
            List<Camera> near = cameras.FindAll(camera => (camera.Pose.Position - Middle).Length <= maxDistance + HalfDiagonal);
            int seen = 0;
            for (int i = 0; i < Grid * Grid; i++)
            {
                double along = ((i / Grid) + 0.5) / Grid;
                double across = ((i % Grid) + 0.5) / Grid;
                Vector3D place =
                    (((Corners[0] * (1 - across)) + (Corners[1] * across)) * (1 - along))
                    + (((Corners[3] * (1 - across)) + (Corners[2] * across)) * along);
                seen += near.Exists(camera => Sees(camera, place, maxDistance)) ? 1 : 0;
            }

            return (double)seen / (Grid * Grid);
        }

        private double HalfDiagonal => (Corners[2] - Corners[0]).Length / 2;

        private static bool Sees(Camera camera, Vector3D place, double maxDistance) =>
            (camera.Pose.Position - place).Length <= maxDistance && camera.Project(place).Outcome == ProjectionOutcome.InImage;

        private bool IsWithin(Vector3D place, Vector2D axis)
        {
            (double from, double to) = Span(Corners, axis);
            double at = new Vector2D(place.X, place.Y).Dot(axis);
            return at >= from - MaxApart && at <= to + MaxApart;
        }

        private static (double From, double To) Span(IReadOnlyList<Vector3D> corners, Vector2D axis)
        {
            // The middles of the two sides, so that a slope does not count as an extent.
            double[] at = [.. corners.Select(corner => new Vector2D(corner.X, corner.Y).Dot(axis)).Order()];
            return ((at[0] + at[1]) / 2, (at[2] + at[3]) / 2);
        }
    }
}
