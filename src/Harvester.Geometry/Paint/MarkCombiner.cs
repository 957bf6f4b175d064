namespace Harvester.Geometry.Paint;

/// <summary>
/// Combines the marks that several images show. A mark counts if it was found in two images or more, or in one from above unless it may be
/// a bar of a crossing, and in at least
/// half of those that show its place. Each of its edges is the median, with weights of 1 / sigma², of the images that show the ground
/// beyond it; if there are none, the outline is that of the part that was seen.
/// </summary>
internal static class MarkCombiner
{
    private const double MinShare = 0.5;

    /// <summary>What a single image from a vehicle shows may be something else than paint.</summary>
    private const int MinImages = 2;

    /// <summary>Greatest distance along the road of the same stop line in two images, metres: three times its standard deviation at 12 m.
    /// Two stop lines of one direction are several metres apart.</summary>
    private const double MaxApart = 0.75;

    /// <summary>The marks in all mouths that were seen.</summary>
    public static List<MarkPaint> Of(JunctionMouths mouths, MarkEvidence evidence)
    {
        var marks = new List<MarkPaint>();
        foreach (KeyValuePair<int, (List<MouthView> Views, List<SeenMark> Marks)> mouth in evidence.Mouths)
        {
            // The surest marks first; each takes those of other images that are the same.
            List<SeenMark> left = [.. mouth.Value.Marks.OrderBy(static mark => mark.Sigma).ThenBy(static mark => mark.Image)];
            while (left.Count > 0)
            {
                SeenMark surest = left[0];
                List<SeenMark> same = left.FindAll(mark => IsSame(mark, surest));
                left.RemoveAll(mark => IsSame(mark, surest));
                if (Combined(same, mouth.Value.Views) is { } mark)
                {
                    marks.Add(OnGround(mark, same, mouths.All[mouth.Key]));
                }
            }
        }

        return marks;
    }

    private static bool IsSame(SeenMark mark, SeenMark other) =>
        mark.Kind == other.Kind
        && mark.Left <= other.Right
        && other.Left <= mark.Right
        && (
            mark.Kind == MarkKind.StopLine
                ? Math.Abs(mark.Middle - other.Middle) <= MaxApart
                : mark.From <= other.To && other.From <= mark.To
        );

    /// <summary>The mark that several images show; null if too many others show that it is not there.</summary>
    private static SeenMark? Combined(List<SeenMark> same, List<MouthView> views)
    {
        SeenMark mark = same[0] with
        {
            From = Edge(same, static mark => (mark.From, mark.IsNearFree), isFirst: true),
            To = Edge(same, static mark => (mark.To, mark.IsFarFree), isFirst: false),
            Left = Edge(same, static mark => (mark.Left, mark.IsLeftFree), isFirst: true),
            Right = Edge(same, static mark => (mark.Right, mark.IsRightFree), isFirst: false),
            Slope = Median(same, static mark => mark.Slope),
            Sigma = Math.Sqrt(1 / same.Sum(Weight)),
        };
        var found = new HashSet<int>(same.Select(static each => each.Image));
        int shown = views.Count(view => found.Contains(view.Image) || view.Shows(mark));
        bool isClear = mark.Kind != MarkKind.StopLine || mark.Right - mark.Left > StopLineFinder.LongestCrossingBar;
        bool isSure = found.Count >= MinImages || isClear && views.Exists(view => view.IsFromAbove && found.Contains(view.Image));
        return isSure && found.Count >= MinShare * shown && mark.Right > mark.Left && mark.To > mark.From ? mark : null;
    }

    /// <summary>The median of the images that show the ground beyond an edge, and in which the mark reaches as far as in any; if there is
    /// none, the outermost place up to which one shows the mark.</summary>
    private static double Edge(List<SeenMark> same, Func<SeenMark, (double Place, bool IsFree)> edge, bool isFirst)
    {
        double outermost = isFirst ? same.Min(mark => edge(mark).Place) : same.Max(mark => edge(mark).Place);
        List<SeenMark> free = same.FindAll(mark => edge(mark).IsFree && Math.Abs(edge(mark).Place - outermost) <= MaxApart);
        return free.Count > 0 ? Median(free, mark => edge(mark).Place) : outermost;
    }

    private static MarkPaint OnGround(SeenMark mark, List<SeenMark> same, JunctionMouth mouth)
    {
        double middle = (mark.Left + mark.Right) / 2;
        Vector3D Corner(double distance, double offset) => mouth.PlaceAt(distance + (mark.Slope * (offset - middle)), offset);
        Vector3D[] corners =
        [
            Corner(mark.From, mark.Left),
            Corner(mark.From, mark.Right),
            Corner(mark.To, mark.Right),
            Corner(mark.To, mark.Left),
        ];
        return new MarkPaint(new PaintedMark(mark.Kind, corners))
        {
            SigmaMetres = mark.Sigma,
            Images = same.Select(static each => each.Image).Distinct().Count(),
        };
    }

    private static double Weight(SeenMark mark) => 1 / (mark.Sigma * mark.Sigma);

    private static double Median(List<SeenMark> marks, Func<SeenMark, double> value) =>
        WeightedMedian.Of(marks.ConvertAll(mark => (value(mark), Weight(mark))));
}
