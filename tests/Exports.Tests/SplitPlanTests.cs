namespace Harvester.Exports.Tests;

public sealed class SplitPlanTests
{
    private static readonly DatasetSplit[] TrainAndVal = [new("train", 0.8), new("val", 0.2)];

    [Fact]
    public void Splits_have_the_requested_shares_on_average()
    {
        var plan = new SplitPlan(TrainAndVal, 1, 1);

        int val = Enumerable.Range(0, 10_000).Count(frame => plan.Of(new FramePlace(0, 0, frame)) == "val");

        // 10,000 draws with p = 0.2: expected 2,000, standard deviation sqrt(10,000 · 0.2 · 0.8) = 40; five of them are 200.
        Assert.InRange(val, 1_800, 2_200);
    }

    [Fact]
    public void Splits_keep_blocks_together()
    {
        var plan = new SplitPlan(TrainAndVal, 1, 25);

        for (int block = 0; block < 40; block++)
        {
            Assert.Single(Enumerable.Range(block * 25, 25).Select(frame => plan.Of(new FramePlace(0, 0, frame))).Distinct());
        }

        Assert.Equal(2, Enumerable.Range(0, 1000).Select(frame => plan.Of(new FramePlace(0, 0, frame))).Distinct().Count());
    }

    [Fact]
    public void Places_stay_whole_without_a_block()
    {
        var plan = new SplitPlan(TrainAndVal, 1);

        string[] Of(int place) =>
            [.. Enumerable.Range(place * 50, 50).Select(frame => plan.Of(new FramePlace(0, place, frame))).Distinct()];

        Assert.All(Enumerable.Range(0, 40), place => Assert.Single(Of(place)));
        Assert.Equal(2, Enumerable.Range(0, 40).SelectMany(Of).Distinct().Count());
    }

    [Fact]
    public void First_full_seed_leaves_no_split_empty()
    {
        FramePlace[] frames = [.. Enumerable.Range(0, 100).Select(frame => new FramePlace(0, frame / 25, frame))];

        int seed = new SplitPlan(TrainAndVal, 0).FirstFullSeed(frames)!.Value;

        Assert.Null(new SplitPlan(TrainAndVal, seed).FirstEmpty(frames));
        Assert.All(Enumerable.Range(0, seed), lower => Assert.NotNull(new SplitPlan(TrainAndVal, lower).FirstEmpty(frames)));
        Assert.Null(new SplitPlan(TrainAndVal, 0).FirstFullSeed(frames[..25]));
    }

    [Fact]
    public void Splits_depend_on_seed_and_session()
    {
        string[] Draw(int seed, int session) =>
            [.. Enumerable.Range(0, 64).Select(frame => new SplitPlan(TrainAndVal, seed, 1).Of(new FramePlace(session, 0, frame)))];

        Assert.Equal(Draw(1, 0), Draw(1, 0));
        Assert.NotEqual(Draw(1, 0), Draw(2, 0));
        Assert.NotEqual(Draw(1, 0), Draw(1, 1));
    }

    [Fact]
    public void Largest_full_block_is_the_largest_that_leaves_no_split_empty()
    {
        FramePlace[] frames = [.. Enumerable.Range(0, 100).Select(frame => new FramePlace(0, 0, frame))];
        var plan = new SplitPlan(TrainAndVal, 0, 100);

        int largest = plan.LargestFullBlock(frames)!.Value;

        Assert.NotNull(plan.FirstEmpty(frames));
        Assert.Equal(["train", "val"], SplitsOf(largest));
        Assert.All(Enumerable.Range(largest + 1, 99 - largest), block => Assert.Single(SplitsOf(block)));

        IEnumerable<string> SplitsOf(int block) =>
            frames.Select(frame => new SplitPlan(TrainAndVal, 0, block).Of(frame)).Distinct().Order();
    }

    [Fact]
    public void No_block_fills_more_splits_than_there_are_frames() =>
        Assert.Null(new SplitPlan(TrainAndVal, 0, 100).LargestFullBlock([new FramePlace(0, 0, 0)]));

    [Theory]
    [InlineData("train", 0.8, "val", 0.1)]
    [InlineData("train", 0.8, "train", 0.2)]
    [InlineData("train", 0.8, "Train", 0.2)]
    [InlineData("train", 1.2, "val", -0.2)]
    [InlineData("../train", 0.8, "val", 0.2)]
    [InlineData("", 0.8, "val", 0.2)]
    [InlineData("train", double.NaN, "val", 0.2)]
    public void Constructor_with_invalid_splits_throws(string first, double firstShare, string second, double secondShare) =>
        Assert.Throws<ArgumentException>(() => new SplitPlan([new(first, firstShare), new(second, secondShare)], 1, 1));
}
