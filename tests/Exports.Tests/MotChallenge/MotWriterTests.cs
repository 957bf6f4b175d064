using Harvester.Exports.Validation;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Tests.MotChallenge;

public sealed class MotWriterTests : ExportTests
{
    private const string Sequence = "out/MOT17-train/sequence-0000";

    [Fact]
    public void Rows_are_those_of_mot17()
    {
        Session.DeterminePedestrians();
        Folder.Export("motchallenge", Session.Open());

        // Pixels count from 1. The car, 5 x 5 visible pixels from (38, 28), is not evaluated (0) and has class 3; of the pedestrian, whose
        // visible box is 10 x 12 from (70, 24), 0.8 is visible.
        Assert.Equal(
            [
                "1,1,39,29,5,5,0,3,0.75",
                "1,2,71,25,10,12,1,1,0.8",
                "2,1,39,29,5,5,0,3,0.75",
                "2,2,71,25,10,12,1,1,0.8",
                "3,1,39,29,5,5,0,3,0.75",
                "3,2,71,25,10,12,1,1,0.8",
            ],
            Folder.Lines(Sequence + "/gt/gt.txt")
        );
    }

    [Fact]
    public void Pedestrian_that_may_be_hidden_is_a_distractor()
    {
        Folder.Export("motchallenge", Session.Open());

        Assert.Equal("1,65536,71,25,10,12,0,8,0", Folder.Lines(Sequence + "/gt/gt.txt")[1]);
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Sequence_has_its_length_rate_and_size()
    {
        Folder.Export("motchallenge", [Session.Open(), Session.Open()]);

        // Frames at 0.5, 1.5 and 2.5 s: one a second.
        Assert.Equal(
            ["[Sequence]", "name=sequence-0000", "imDir=img1", "frameRate=1", "seqLength=3", "imWidth=80", "imHeight=60", "imExt=.png"],
            Folder.Lines(Sequence + "/seqinfo.ini")
        );
        Assert.Equal(["name", "sequence-0000", "sequence-0001"], Folder.Lines("out/seqmaps/MOT17-train.txt"));
        Assert.True(File.Exists(Folder.PathOf(Sequence + "/img1/000003.png")));
    }

    [Fact]
    public void Amodal_boxes_reach_beyond_the_image()
    {
        Session.DeterminePedestrians();
        Folder.Export("motchallenge", Session.Open(), new ExportOptions { Boxes = BoxKind.Amodal });

        // From column 70 to 82 of 80.
        Assert.Equal("1,2,71,25,12,12,1,1,0.8", Folder.Lines(Sequence + "/gt/gt.txt")[1]);
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Sequence_without_objects_has_an_empty_gt()
    {
        Session.Lines.ForEach(line => line["objects"]!.AsArray().Clear());
        Folder.Export("motchallenge", Session.Open());

        Assert.Empty(Folder.Lines(Sequence + "/gt/gt.txt"));
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }
}
