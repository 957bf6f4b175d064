using System.Text.Json.Nodes;
using Harvester.Exports.Predictions;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Predictions;

public sealed class PredictionEvaluationTests : IDisposable
{
    private const int Car = (int)ObjectClass.Car;

    /// <summary>The car's box around its 5 x 5 visible pixels, as COCO's export has it; category 1 is car.</summary>
    private const string Right = """{ "image_id": 0, "category_id": 1, "bbox": [38, 28, 5, 5], "score": 0.9 }""";

    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Matches_misses_and_false_positives_are_counted()
    {
        PredictionEvaluation evaluation = Evaluate(
            $$"""
            [{{Right}}, { "image_id": 1, "category_id": 1, "bbox": [0, 0, 5, 5], "score": 0.8 }]
            """
        );

        OutcomeCount cars = evaluation.Groups.Classes[Car];
        Assert.Equal((1, 2, 1), (cars.Matches, cars.Misses, cars.FalsePositives));
        Assert.Equal([0, 2, 1], evaluation.ErrorsOfFrames);
        Assert.Equal([1, 2], evaluation.WorstFrames(9));
        Assert.Equal(3, evaluation.Tallies[Car].CountIn(0));
    }

    [Fact]
    public void Car_11_m_away_and_hidden_by_a_quarter_is_counted_there()
    {
        PredictionEvaluation evaluation = Evaluate($"[{Right}]");

        Assert.Equal(("10 to 20 m", 1, 2), Group(evaluation.Groups.Distances));
        Assert.Equal(("10 to 50 % hidden", 1, 2), Group(evaluation.Groups.Occlusions));
        Assert.Equal(("small, up to 32² px", 1, 2), Group(evaluation.Groups.Sizes));
    }

    /// <summary>
    /// The image has 80 x 60 pixels. By columns, the box begins after 38 * 60 + 28 pixels and has 5 in each of 5 columns; the compressed
    /// text of these run lengths is what rleToString of COCO's maskApi.c defines.
    /// </summary>
    [Theory]
    [InlineData("[[38, 28, 43, 28, 43, 33, 38, 33]]")]
    [InlineData("""{ "size": [60, 80], "counts": [2308, 5, 55, 5, 55, 5, 55, 5, 55, 5, 2247] }""")]
    [InlineData("""{ "size": [60, 80], "counts": "TX25g10000000`T2" }""")]
    public void Result_without_a_box_has_that_of_its_segmentation(string segmentation)
    {
        PredictionEvaluation evaluation = Evaluate(
            $$"""[{ "image_id": 0, "category_id": 1, "segmentation": {{segmentation}}, "score": 0.9 }]"""
        );

        Assert.Equal((1, 2, 0), (evaluation.Groups.All.Matches, evaluation.Groups.All.Misses, evaluation.Groups.All.FalsePositives));
        Assert.Equal(34 / 101.0, evaluation.MeanOf(tally => tally.AveragePrecision(0))!.Value, 1e-12);
    }

    [Fact]
    public void Byte_order_mark_is_skipped() => Assert.Equal(1, Evaluate($"\uFEFF[{Right}]").Groups.All.Matches);

    [Fact]
    public void Score_below_the_minimum_is_neither_match_nor_false_positive()
    {
        PredictionEvaluation evaluation = Evaluate($"[{Right}]", minScore: 0.95);

        Assert.Equal((0, 3, 0), (evaluation.Groups.All.Matches, evaluation.Groups.All.Misses, evaluation.Groups.All.FalsePositives));
        Assert.True(evaluation.Tallies[Car].AveragePrecision(0) > 0);
    }

    [Fact]
    public void Pedestrian_of_unknown_visibility_is_an_ignore_region()
    {
        PredictionEvaluation evaluation = Evaluate("""[{ "image_id": 0, "category_id": 7, "bbox": [71, 25, 5, 5], "score": 0.9 }]""");

        Assert.Equal(0, evaluation.Groups.All.FalsePositives);
        Assert.Equal(0, evaluation.Tallies[(int)ObjectClass.Pedestrian].CountIn(0));
    }

    [Fact]
    public void KITTI_results_are_compared_in_the_pixels_of_KITTI()
    {
        // Half a pixel less than in the session: 38 - 0.5 and so on.
        WriteKitti(0, "Car -1 -1 -10 37.5 27.5 42.5 32.5 -1 -1 -1 -1000 -1000 -1000 -10 0.9\n");
        WriteKitti(1, "");
        WriteKitti(2, "DontCare -1 -1 -10 0 0 5 5 -1 -1 -1 -1000 -1000 -1000 -10\n");

        PredictionEvaluation evaluation = PredictionEvaluation.Of(_session.Open(), _session.PathOf("kitti"), 0.5);

        Assert.Equal((1, 2, 0), (evaluation.Groups.All.Matches, evaluation.Groups.All.Misses, evaluation.Groups.All.FalsePositives));
        Assert.Equal(34 / 101.0, evaluation.MeanOf(tally => tally.AveragePrecision(0))!.Value, 1e-12);
    }

    [Fact]
    public void KITTI_results_may_have_tabs_between_columns()
    {
        WriteKitti(0, "Car -1 -1 -10 37.5 27.5 42.5 32.5 -1 -1 -1 -1000 -1000 -1000 -10 0.9\n".Replace(' ', '\t'));
        WriteKitti(1, "");
        WriteKitti(2, "");

        Assert.Equal(1, PredictionEvaluation.Of(_session.Open(), _session.PathOf("kitti"), 0.5).Groups.All.Matches);
    }

    [Fact]
    public void Boxes_are_rounded_as_in_the_export()
    {
        // The export has 38.625 - 0.5 as 38.13, not 38.12. The prediction covers 2.187 of 4.37 pixels, 50.05 %; of 4.38 less.
        _session.Car(0)["box2dVisible"] = new JsonArray(38.625, 28, 43, 33);
        WriteKitti(0, "Car -1 -1 -10 38.2 27.5 40.387 32.5 -1 -1 -1 -1000 -1000 -1000 -10 0.9\n");
        WriteKitti(1, "");
        WriteKitti(2, "");

        PredictionEvaluation evaluation = PredictionEvaluation.Of(_session.Open(), _session.PathOf("kitti"), 0.5);

        Assert.Equal((1, 2, 0), (evaluation.Groups.All.Matches, evaluation.Groups.All.Misses, evaluation.Groups.All.FalsePositives));
    }

    [Theory]
    [InlineData("[", "predictions.json': invalid JSON at line 1, byte 2.")]
    [InlineData("{}", "is not COCO results: it must be a JSON list")]
    [InlineData("[7]", "line 1: the text")]
    [InlineData("[\n{ 'image_id': 3, 'category_id': 1, 'bbox': [0, 0, 1, 1], 'score': 1 }]", "line 2: image_id 3 is unknown")]
    [InlineData("[{ 'image_id': -1, 'category_id': 1, 'bbox': [0, 0, 1, 1], 'score': 1 }]", "the images of the session are 0 to 2")]
    [InlineData("[{ 'image_id': 0, 'category_id': 12, 'bbox': [0, 0, 1, 1], 'score': 1 }]", "category_id 12 is unknown")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'bbox': [0, 0, -1, 1], 'score': 1 }]", "are -1 and 1, less than 0")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'bbox': [0, 0, NaN, 1], 'score': 1 }]", "JSON has no NaN and Infinity")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'bbox': [0, 0, 1e99, 1], 'score': 1 }]", "bbox")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'bbox': [0, 0, 1], 'score': 1 }]", "bbox")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'segmentation': 7, 'score': 1 }]", "segmentation is neither")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'segmentation': [[1, 2, 3]], 'score': 1 }]", "segmentation is neither")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'segmentation': { 'size': [60, 80] }, 'score': 1 }]", "segmentation is neither")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'segmentation': { 'size': [0, 80], 'counts': [] }, 'score': 1 }]", "the size of")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'segmentation': { 'size': [1, 8], 'counts': [9] }, 'score': 1 }]", "do not fit")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'segmentation': { 'size': [1, 8], 'counts': 'zzzz' }, 'score': 1 }]", "compressed")]
    [InlineData("[{ 'image_id': 0, 'category_id': 1, 'bbox': [0, 0, 1, 1] }]", "score is missing")]
    public void Bad_COCO_results_are_refused_with_their_line(string results, string message)
    {
        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() => Evaluate(results.Replace('\'', '"')));

        Assert.Contains(message, e.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Car -1 -1 -10 1 1 2 2 -1 -1 -1 -1000 -1000 -1000 -10", "it has 15 columns instead of 16; the last is the score")]
    [InlineData("Bus -1 -1 -10 1 1 2 2 -1 -1 -1 -1000 -1000 -1000 -10 1", "type 'Bus' is unknown")]
    [InlineData("Car -1 -1 -10 1 1 2 2 -1 -1 -1 -1000 -1000 -1000 -10 NaN", "is not a number from -1e9 to 1e9")]
    [InlineData("Car -1 -1 -10 1 1 1e10 2 -1 -1 -1 -1000 -1000 -1000 -10 1", "is not a number from -1e9 to 1e9")]
    [InlineData("Car -1 -1 -10 2 1 1 2 -1 -1 -1 -1000 -1000 -1000 -10 1", "right or bottom is less than left or top")]
    public void Bad_KITTI_results_are_refused_with_file_and_line(string line, string message)
    {
        WriteKitti(0, "\n" + line + "\n");

        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() =>
            PredictionEvaluation.Of(_session.Open(), _session.PathOf("kitti"), 0.5)
        );

        Assert.Contains("000000.txt', line 2: ", e.Message, StringComparison.Ordinal);
        Assert.Contains(message, e.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("000001.txt", "has no 000002.txt")]
    [InlineData("000001.txt 000002.txt 000003.txt", "000003.txt' belongs to no frame")]
    [InlineData("first.txt", "first.txt' is not named by the number of a frame")]
    public void Each_frame_needs_one_file_of_KITTI_results(string others, string message)
    {
        WriteKitti(0, "");
        foreach (string name in others.Split(' '))
        {
            File.WriteAllText(_session.PathOf($"kitti/{name}"), "");
        }

        DatasetFormatException e = Assert.Throws<DatasetFormatException>(() =>
            PredictionEvaluation.Of(_session.Open(), _session.PathOf("kitti"), 0.5)
        );

        Assert.Contains(message, e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Missing_predictions_are_an_input_error() =>
        Assert.Throws<FileNotFoundException>(() => PredictionEvaluation.Of(_session.Open(), _session.PathOf("none.json"), 0.5));

    private PredictionEvaluation Evaluate(string results, double minScore = 0.5)
    {
        string path = _session.PathOf("predictions.json");
        File.WriteAllText(path, results);
        return PredictionEvaluation.Of(_session.Open(), path, minScore);
    }

    private void WriteKitti(int frame, string text)
    {
        Directory.CreateDirectory(_session.PathOf("kitti"));
        File.WriteAllText(_session.PathOf($"kitti/{frame:D6}.txt"), text);
    }

    private static (string Name, int Matches, int Misses) Group(IEnumerable<OutcomeCount> groups)
    {
        OutcomeCount group = Assert.Single(groups, count => count.Matches + count.Misses > 0);
        return (group.Name, group.Matches, group.Misses);
    }
}
