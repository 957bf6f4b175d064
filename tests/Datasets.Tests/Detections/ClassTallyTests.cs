using Harvester.Datasets.Detections;
using Harvester.Geometry;

namespace Harvester.Datasets.Tests.Detections;

public sealed class ClassTallyTests
{
    private const int All = 0;
    private const int Small = 1;
    private const int Large = 3;

    /// <summary>Sums of a hundred fractions are rounded.</summary>
    private const double Rounding = 1e-12;

    private static readonly Box2D Square = new(10, 10, 20, 20);
    private static readonly Box2D Elsewhere = new(50, 50, 60, 60);

    [Fact]
    public void Perfect_prediction_has_an_average_precision_of_1()
    {
        ClassTally tally = Tally([Predicted(Square, 0.3)], [Truth(Square)]);

        Assert.Equal(1, tally.AveragePrecision(All)!.Value, Rounding);
        Assert.Equal(1, tally.AverageRecall(0)!.Value, Rounding);
    }

    [Fact]
    public void Precision_counts_up_to_the_recall_that_is_reached()
    {
        // The false positive comes first, so precision is 1/2 where recall reaches 1/2: at 51 of 101 recalls.
        ClassTally tally = Tally([Predicted(Square, 0.8), Predicted(new Box2D(80, 80, 90, 90), 0.9)], [Truth(Square), Truth(Elsewhere)]);

        Assert.Equal(51 * 0.5 / 101, tally.AveragePrecision(All)!.Value, Rounding);
        Assert.Equal(0.5, tally.AverageRecall(2)!.Value, Rounding);
    }

    [Fact]
    public void Overlap_of_0_6_matches_three_of_ten_thresholds()
    {
        // 60 of 100 square pixels: enough for 0.5, 0.55 and 0.6.
        ClassTally tally = Tally([Predicted(new Box2D(10, 10, 20, 16), 0.9)], [Truth(Square)]);

        Assert.Equal(0.3, tally.AveragePrecision(All)!.Value, Rounding);
        Assert.Equal(1, tally.AveragePrecisionAt(0)!.Value, Rounding);
    }

    [Fact]
    public void Second_prediction_of_an_object_is_a_false_positive()
    {
        // Precision 1 up to recall 1/2, then 2/3: the second of three predictions is wrong.
        ClassTally tally = Tally(
            [Predicted(Square, 0.9), Predicted(Square, 0.8), Predicted(Elsewhere, 0.7)],
            [Truth(Square), Truth(Elsewhere)]
        );

        Assert.Equal((51 + (50 * 2 / 3.0)) / 101, tally.AveragePrecision(All)!.Value, Rounding);
    }

    [Fact]
    public void Predictions_in_an_ignore_region_do_not_count()
    {
        ClassTally tally = Tally(
            [Predicted(new Box2D(50, 50, 55, 55), 0.95), Predicted(new Box2D(55, 55, 60, 60), 0.9), Predicted(Square, 0.5)],
            [Truth(Square), new TruthBox(0, Elsewhere, 100, IsCrowd: true)]
        );

        Assert.Equal(1, tally.AveragePrecision(All)!.Value, Rounding);
    }

    [Fact]
    public void Sizes_are_evaluated_apart()
    {
        // 10² is small, 100² large; both predictions are right, and neither is a false positive of the other range.
        var large = new Box2D(100, 100, 200, 200);
        ClassTally tally = Tally([Predicted(large, 0.9), Predicted(Square, 0.8)], [Truth(Square), Truth(large)]);

        Assert.Equal(1, tally.AveragePrecision(Small)!.Value, Rounding);
        Assert.Equal(1, tally.AveragePrecision(Large)!.Value, Rounding);
        Assert.Equal((1, 0, 1), (tally.CountIn(Small), tally.CountIn(2), tally.CountIn(Large)));
    }

    [Fact]
    public void Class_without_objects_has_no_average_precision()
    {
        ClassTally tally = Tally([Predicted(Square, 0.9)], []);

        Assert.Null(tally.AveragePrecision(All));
        Assert.Null(tally.AverageRecall(0));
        Assert.Null(tally.AverageRecallIn(Small));
    }

    [Fact]
    public void At_most_100_predictions_of_an_image_count()
    {
        IEnumerable<PredictedBox> wrong = Enumerable.Range(0, 100).Select(i => Predicted(new Box2D(i, 80, i + 5, 85), 0.9));

        ClassTally tally = Tally([.. wrong, Predicted(Square, 0.1)], [Truth(Square)]);

        Assert.Equal(0, tally.AveragePrecision(All));
    }

    [Fact]
    public void Recall_with_one_prediction_counts_the_most_certain()
    {
        ClassTally tally = Tally([Predicted(Square, 0.9), Predicted(Elsewhere, 0.8)], [Truth(Square), Truth(Elsewhere)]);

        Assert.Equal(0.5, tally.AverageRecall(0)!.Value, Rounding);
        Assert.Equal(1, tally.AverageRecall(1)!.Value, Rounding);
    }

    private static PredictedBox Predicted(Box2D box, double score) => new(0, 0, box, score);

    private static TruthBox Truth(Box2D box) => new(0, box, box.Area, IsCrowd: false);

    private static ClassTally Tally(IEnumerable<PredictedBox> predictions, IEnumerable<TruthBox> truth)
    {
        var tally = new ClassTally();
        tally.Add(new ClassMatches(predictions, truth));
        return tally;
    }
}
