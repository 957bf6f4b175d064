using Harvester.TestSupport;

namespace Harvester.Exports.Tests.MotChallenge;

public sealed class MotCheckTests(SimulatedSession simulated) : CheckTests(simulated, "motchallenge")
{
    private const string Sequence = "MOT17-train/sequence-0000";
    private const string Truth = Sequence + "/gt/gt.txt";
    private const string Info = Sequence + "/seqinfo.ini";

    [Theory]
    [InlineData("^1,", "0,", "frame 0 has no image.")]
    [InlineData("^1,", "8,", "frame 8 has no image.")]
    [InlineData("^1,", "1,1,", "it must have 9 numbers, separated by commas.")]
    [InlineData("^1,[^,]*,", "1,x,", "it must have 9 numbers, separated by commas.")]
    [InlineData("^1,[^,]*,", "1,0,", "its id is not a whole number from 1.")]
    [InlineData("^(1,[^,]*),[^,]*,", "$1,300,", "its box does not lie in the image of 200 x 150, or has no area.")]
    [InlineData("^(1,.*),[^,]*$", "$1,2", "its visibility is not 0 to 1.")]
    [InlineData("^(1,.*),[^,]*,([^,]*)$", "$1,13,$2", "its class is not 1 to 12.")]
    [InlineData("^(1,.*),0,3,", "$1,1,3,", "its flag is not 1 for class 1 and 0 for others.")]
    public void A_damaged_row_is_found(string pattern, string replacement, string expected)
    {
        Export();
        Damage(Truth, pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith(Truth + ", line ", StringComparison.Ordinal) && problem.EndsWith(expected, StringComparison.Ordinal)
        );
    }

    [Theory]
    [InlineData("seqLength=7", "seqLength=8", "seqLength is not 7, the number of images in img1.")]
    [InlineData("imWidth=200", "imWidth=201", "imWidth and imHeight are not those of its images, 200 x 150.")]
    [InlineData("frameRate=.*", "frameRate=0", "frameRate is not a number above 0.")]
    [InlineData("imExt=.png", "imExt=.jpg", "img1 has no image 000001.jpg.")]
    [InlineData("\\[Sequence\\]", "", "it is missing, or has no section [Sequence].")]
    public void Damaged_sequence_information_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Info, pattern, replacement, $"{Info}: {expected}");

    [Fact]
    public void Object_in_two_rows_of_a_frame_is_found()
    {
        Export();
        Damage(Truth, "^(.*\n)", "$1$1");
        AssertFound($"{Truth}, line 2: id ");
    }

    [Fact]
    public void Lost_rows_images_and_lists_are_found()
    {
        Export();
        Delete(Truth);
        Delete("seqmaps/MOT17-train.txt");
        Delete(Sequence + "/img1/000003.png");
        AssertFound($"{Truth}: it is missing.");
        AssertFound("seqmaps/MOT17-train.txt: it must be the line 'name'");
        AssertFound($"{Info}: seqLength is not 6");
    }
}
