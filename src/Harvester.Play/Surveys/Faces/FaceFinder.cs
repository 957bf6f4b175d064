using Harvester.Geometry.Work;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Finds the faces of a sign: a grid of rays shows the rows in which the model is wider than its post, in bands of equal depth, and the
/// edges of each band's plate are followed on the side that faces away from the post.
/// </summary>
internal sealed class FaceFinder(StageProbe probe, StagedModel model)
{
    private const double FinestStep = 0.012;
    private const double MaxRays = 30_000;

    /// <summary>Maximum difference in depth of rows of one plate, metres.</summary>
    private const double SamePlane = 0.02;

    /// <summary>Minimum height of a face, metres; lower ones are rims and brackets.</summary>
    private const double MinFaceHeight = 0.08;

    /// <summary>The faces found so far.</summary>
    public List<MeasuredFace> Faces { get; } = [];

    /// <summary>Measures the model.</summary>
    public IEnumerable<WorkStep> Run()
    {
        double area = (model.Max.X - model.Min.X) * (model.Max.Z - model.Min.Z);
        var grid = new ModelDepths(model.Min.X, model.Min.Z, model.Max.X, model.Max.Z, Math.Max(FinestStep, Math.Sqrt(area / MaxRays)));
        yield return WorkStep.Do(grid.Fill(probe));

        if (SignPost.Find(grid) is not { } post)
        {
            yield break;
        }

        foreach ((int first, int last) in Bands(grid, post))
        {
            var plate = new PlateFinder(probe, grid, post, first, last);
            yield return WorkStep.Do(plate.Run());

            if (plate.Found is { } face && face.Max.Z - face.Min.Z >= MinFaceHeight && !Faces.Any(other => AreOne(face, other)))
            {
                Faces.Add(face);
            }
        }
    }

    private static List<(int First, int Last)> Bands(ModelDepths grid, SignPost post)
    {
        var bands = new List<(int First, int Last)>();
        double before = 0;
        for (int row = 0; row < grid.Rows; row++)
        {
            if (!post.IsNarrowerThan(grid.Width(row)) || grid.MedianDepth(row, column => !post.HasColumn(column)) is not { } depth)
            {
                continue;
            }

            bool goesOn = bands.Count > 0 && bands[bands.Count - 1].Last == row - 1 && Math.Abs(depth - before) <= SamePlane;
            if (goesOn)
            {
                bands[bands.Count - 1] = (bands[bands.Count - 1].First, row);
            }
            else
            {
                bands.Add((row, row));
            }

            before = depth;
        }

        return bands;
    }

    /// <summary>Whether two faces overlap by more than half of the smaller one: bands of one plate.</summary>
    private static bool AreOne(MeasuredFace one, MeasuredFace other)
    {
        double width = Math.Min(one.Max.X, other.Max.X) - Math.Max(one.Min.X, other.Min.X);
        double height = Math.Min(one.Max.Z, other.Max.Z) - Math.Max(one.Min.Z, other.Min.Z);
        return width > 0 && height > 0 && 2 * width * height > Math.Min(Area(one), Area(other));
    }

    private static double Area(MeasuredFace face) => (face.Max.X - face.Min.X) * (face.Max.Z - face.Min.Z);
}
