using System.Text.Json.Nodes;
using Harvester.Exports.Validation;

namespace Harvester.Exports.Tests;

/// <summary>A place that a session visits is a sequence of its own in every format that has sequences.</summary>
public sealed class SequenceTests : ExportTests
{
    [Theory]
    [InlineData("motchallenge", "MOT17-train/sequence-0000/img1/000002.png", "MOT17-train/sequence-0001/img1/000001.png")]
    [InlineData("kitti-tracking", "training/image_02/0000/000001.png", "training/image_02/0001/000000.png")]
    [InlineData("kitti-odometry", "sequences/00/image_2/000001.png", "sequences/01/image_2/000000.png")]
    [InlineData("jta", "frames/train/seq_0/2.png", "frames/train/seq_1/1.png")]
    [InlineData("openlabel", "images/train/0000/00000001.png", "images/train/0001/00000000.png")]
    [InlineData("mcap", "train/0000.mcap", "train/0001.mcap")]
    [InlineData(
        "cityscapes",
        "leftImg8bit/train/session0000/session0000_000000_000001_leftImg8bit.png",
        "leftImg8bit/train/session0000/session0000_000001_000000_leftImg8bit.png"
    )]
    public void New_place_is_a_new_sequence(string format, string first, string second)
    {
        VisitTwoPlaces();
        Folder.Export(format, Session.Open());

        Assert.True(File.Exists(Folder.PathOf("out/" + first)));
        Assert.True(File.Exists(Folder.PathOf("out/" + second)));
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void New_place_is_a_new_scene_of_nuscenes()
    {
        VisitTwoPlaces();

        // The pedestrian of the session is a plate, and boxes of nuScenes have three sides above 0.
        Session.Lines.ForEach(line => line["objects"]![1]!["box3d"]!["halfExtents"] = new JsonArray(1, 0.1, 1));
        Folder.Export("nuscenes", Session.Open());

        Assert.Equal(
            ["maps/scene-2001.png", "maps/scene-2002.png"],
            Directory.GetFiles(Folder.PathOf("out/maps")).Order().Select(file => "maps/" + Path.GetFileName(file))
        );
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void New_place_is_a_new_video_of_bdd100k()
    {
        VisitTwoPlaces();
        Folder.Export("bdd100k", Session.Open());

        JsonArray frames = JsonNode.Parse(File.ReadAllText(Folder.PathOf("out/labels/det_20/det_train.json")))!.AsArray();
        Assert.Equal(
            [("sequence-0000", 0), ("sequence-0000", 1), ("sequence-0001", 0)],
            frames.Select(frame => ((string)frame!["videoName"]!, (int)frame["frameIndex"]!))
        );
    }

    [Fact]
    public void Frame_rate_ignores_the_time_between_places()
    {
        VisitTwoPlaces();
        Session.Info["options"] = new JsonObject { ["rateHz"] = 10 };
        (Session.Lines[0]["timeSeconds"], Session.Lines[1]["timeSeconds"], Session.Lines[2]["timeSeconds"]) = (1, 1.1, 90);
        Folder.Export("motchallenge", Session.Open());

        Assert.Contains("frameRate=10", Folder.Lines("out/MOT17-train/sequence-0000/seqinfo.ini"));
        Assert.Contains("frameRate=10", Folder.Lines("out/MOT17-train/sequence-0001/seqinfo.ini"));
    }

    [Fact]
    public void Splits_keep_neighbouring_frames_together_by_default()
    {
        VisitTwoPlaces();
        DatasetSplit[] halves = [new("train", 0.5), new("val", 0.5)];
        int seed = Enumerable
            .Range(0, 100)
            .First(each => new SplitPlan(halves, each).Of(new(0, 0, 0)) != new SplitPlan(halves, each).Of(new(0, 1, 2)));
        Folder.Export("csv", Session.Open(), new ExportOptions { Splits = new SplitPlan(halves, seed) });

        string[] splits = [.. Folder.Lines("out/frames.csv").Skip(1).Select(line => line.Split(',')[1])];
        Assert.Equal(splits[0], splits[1]);
        Assert.NotEqual(splits[1], splits[2]);
    }

    private void VisitTwoPlaces()
    {
        Session.DeterminePedestrians();
        for (int line = 0; line < 3; line++)
        {
            Session.Lines[line]["place"] = line / 2;
            Session.Lines[line]["placeFrame"] = line % 2;
        }
    }
}
