using Harvester.TestSupport;

namespace Harvester.Exports.Tests.DeepDriving;

public sealed class DeepDrivingCheckTests(SimulatedSession simulated) : CheckTests(simulated, "deepdriving")
{
    private const string Table = "indicators.csv";

    [Theory]
    [InlineData("^frame,", "number,", 1, "its columns are not those of the format.")]
    [InlineData("^0,train,", "0,", 2, "it has 57 columns instead of 58.")]
    [InlineData("^0,train,", "0,test,", 2, "'test' is not a split of the export.")]
    [InlineData("^0,train,images/00000000.png,[^,]*", "0,train,images/00000000.png,maybe", 2, "its status or fast has an unknown value.")]
    [InlineData("^0,train,images/00000000", "0,train,images/00000009", 2, "its image 'images/00000009.png' is missing, or occurs twice.")]
    [InlineData("^1,train,images/00000001", "1,train,images/00000000", 3, "its image 'images/00000000.png' is missing, or occurs twice.")]
    [InlineData("^(0(,[^,]*){4}),[^,]*", "$1,x", 2, "a value is not a number.")]
    [InlineData("^(0(,[^,]*){4}),[^,]*", "$1,4", 2, "angle is not from -pi to pi.")]
    [InlineData("^(0(,[^,]*){5}),[^,]*", "$1,-6.5", 2, "indicators/00000000.txt is missing, or its numbers differ.")]
    [InlineData("^(0(,[^,]*){17}),[^,]*", "$1,2", 2, "a valid_ column is not 0 or 1.")]
    [InlineData("^(0(,[^,]*){31}),[^,]*", "$1,-6.5", 2, "normalised_toMarking_L does not follow from its value.")]
    [InlineData("^(0(,[^,]*){44}),[^,]*", "$1,0.5", 2, "normalised_toMarking_L does not follow from its value.")]
    [InlineData("^(0,.*),[^,]*$", "$1,0.5", 2, "normalised_fast does not follow from its value.")]
    public void A_damaged_row_is_found(string pattern, string replacement, int line, string expected) =>
        AssertDamageIsFound(Table, pattern, replacement, $"{Table}, line {line}: {expected}");

    [Theory]
    [InlineData("indicators/00000003.txt", "^\\S+", "0.5")]
    [InlineData("normalised/00000003.txt", " \\S+$", "")]
    public void A_damaged_text_is_found(string file, string pattern, string replacement) =>
        AssertDamageIsFound(file, pattern, replacement, $"{Table}, line 5: {file} is missing, or its numbers differ.");

    [Theory]
    [InlineData(Table, Table + ": it is missing.")]
    [InlineData("images/00000003.png", Table + ", line 5: its image 'images/00000003.png' is missing, or occurs twice.")]
    [InlineData("images/00000003.png", "indicators/00000003.txt: its image is missing.")]
    [InlineData("normalised/00000003.txt", Table + ", line 5: normalised/00000003.txt is missing, or its numbers differ.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    [Fact]
    public void Image_without_a_row_is_found()
    {
        Export();
        Damage(Table, "^3,.*\n", "");
        AssertFound($"{Table}: image '00000003' has no row.");
    }

    [Fact]
    public void An_image_of_another_size_is_found()
    {
        Export();
        File.WriteAllBytes(Folder.PathOf("out/images/00000003.png"), TestImages.Png(200, 150));
        AssertFound($"{Table}, line 5: its image is 200 x 150, not 280 x 210.");
    }
}
