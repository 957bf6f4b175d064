using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Csv;

public sealed class CsvDatasetCheckTests(SimulatedSession simulated) : CheckTests(simulated, "csv")
{
    [Theory]
    [InlineData("^frame,", "number,", 1, "its columns are not those of the format.")]
    [InlineData("^0,train,", "0,", 2, " fields instead of ")]
    [InlineData("^0,train,", "0,test,", 2, "'test' is not a split of the export.")]
    [InlineData("^1,train,", "0,train,", 3, "frame 0 occurs twice.")]
    [InlineData("images/00000000", "images/99999999", 2, "its image 'images/99999999.png' is missing.")]
    [InlineData(",200,150,", ",300,150,", 2, "its image is 200 x 150, not 300 x 150.")]
    [InlineData(",200,150,", ",200,many,", 2, "height is not a number.")]
    [InlineData(",(\\d\\d):\\d\\d:\\d\\d,", ",$1h,", 2, "time_of_day is not a time such as 13:05:00.")]
    public void A_damaged_frame_is_found_with_its_line(string pattern, string replacement, int line, string expected)
    {
        Export();
        Damage("frames.csv", pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith($"frames.csv, line {line}: ", StringComparison.Ordinal)
                && problem.Contains(expected, StringComparison.Ordinal)
        );
    }

    [Theory]
    [InlineData("^0,", "70,", "frame 70 is not in frames.csv.")]
    [InlineData("^(0,1),[a-zA-Z]+", "$1,lorry", "'lorry' is not a class of the export.")]
    [InlineData("^(0(,[^,]*){4}),[^,]*", "$1,-9", "its box2d does not lie in the image of 200 x 150, or has no area.")]
    [InlineData("^(0(,[^,]*){6}),[^,]*", "$1,300", "its box2d does not lie in the image of 200 x 150, or has no area.")]
    [InlineData("^(0(,[^,]*){16}),[^,]*", "$1,1.5", "truncated_fraction is not 0 to 1.")]
    [InlineData("^(0(,[^,]*){16}),[^,]*", "$1,x", "truncated_fraction is not a number.")]
    public void A_damaged_object_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound("objects.csv", pattern, replacement, $"objects.csv, line 2: {expected}");

    [Fact]
    public void Duplicate_object_is_found()
    {
        Export();
        Damage("objects.csv", "^(0,1,.*\n)", "$1$1");
        AssertFound("objects.csv, line 3: object 1 occurs twice in frame 0.");
    }

    [Theory]
    [InlineData("0,0,1,nearMiss", null)]
    [InlineData("0,0,2,wrongWay", null)]
    [InlineData("70,0,1,nearMiss", "frame 70 is not in frames.csv.")]
    [InlineData("0,0,0,nearMiss", "'0' is not the number of an event.")]
    [InlineData("0,0,x,nearMiss", "event is not a number.")]
    [InlineData("0,0,1,crash", "'crash' is not a kind of event.")]
    public void Events_are_checked(string row, string? expected)
    {
        Export();
        File.WriteAllText(Folder.PathOf("out/events.csv"), $"frame,session,event,kind\n{row}\n");
        if (expected is null)
        {
            Assert.DoesNotContain(Problems(), problem => problem.StartsWith("events.csv, line", StringComparison.Ordinal));
        }
        else
        {
            AssertFound($"events.csv, line 2: {expected}");
        }
    }

    [Theory]
    [InlineData("frames.csv", "frames.csv: it is missing.")]
    [InlineData("objects.csv", "objects.csv: it is missing.")]
    [InlineData("images/00000002.png", "frames.csv, line 4: its image 'images/00000002.png' is missing.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);
}
