using System.Globalization;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Tests.Text;

public sealed class IniFileTests
{
    [Fact]
    public void Values_are_found_by_section_and_name_in_any_case()
    {
        IniFile ini = Read("[Camera]\r\nOffset = 2\n[other]\nOFFSET=3\n");

        Assert.Equal(2, ini.Number("camera", "offset", 9, 0, 10));
        Assert.Equal(3, ini.Whole("Other", "Offset", 9, 0, 10));
        Assert.Empty(ini.Complaints);
    }

    [Fact]
    public void Comments_are_ignored_but_not_a_semicolon_within_a_value()
    {
        IniFile ini = Read("\uFEFF; head\n# too\n[S]\nA = x;y//z ; the rest\n");

        Assert.Equal("x;y//z", ini.Text("S", "A", "none"));
        Assert.Empty(ini.Complaints);
    }

    [Fact]
    public void Changes_lists_values_other_than_the_default_in_file_order()
    {
        IniFile ini = Read(
            "[S]\nText = other\nSame = 5.0\nFormat = bmp\nBad = x\nClasses = bus, car\nAlike = car, bus\nUnasked = 1\nEmpty =\n"
        );
        ini.Choices<ObjectClass>("S", "Alike", [ObjectClass.Car, ObjectClass.Bus], "classes");
        ini.Choices<ObjectClass>("S", "Classes", [ObjectClass.Car, ObjectClass.Bus], "classes");
        ini.Choice("S", "Format", ImageFormat.Png, "PNG or BMP");
        ini.Number("S", "Same", 5, 0, 10);
        ini.Number("S", "Bad", 5, 0, 10);
        ini.Text("S", "Text", "one");
        ini.Text("S", "Empty", "full");

        Assert.Equal(["[S] Text = other", "[S] Format = bmp", "[S] Classes = bus, car"], ini.Changes);
    }

    [Fact]
    public void Number_is_read_the_same_in_every_culture()
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        var commas = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        commas.NumberFormat.NumberDecimalSeparator = ",";
        commas.NumberFormat.NumberGroupSeparator = ".";
        CultureInfo.CurrentCulture = commas;
        try
        {
            IniFile ini = Read("[S]\nA = 0.5\nB = 0,5\n");
            Assert.Equal(0.5, ini.Number("S", "A", 1, 0, 10));
            Assert.Equal(1, ini.Number("S", "B", 1, 0, 10));
            Assert.Equal("Line 3: B = 0,5 is not a number from 0 to 10; the default is used.", Assert.Single(ini.Complaints));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Theory]
    [InlineData("11")]
    [InlineData("-1")]
    [InlineData("NaN")]
    [InlineData("1e999")]
    [InlineData("many")]
    public void Bad_number_is_reported_with_its_line_and_the_default_used(string text)
    {
        IniFile ini = Read($"[S]\n\nA = {text}\n");

        Assert.Equal(7, ini.Number("S", "A", 7, 0, 10));
        Assert.Equal($"Line 3: A = {text} is not a number from 0 to 10; the default is used.", Assert.Single(ini.Complaints));
    }

    [Fact]
    public void Missing_and_empty_values_silently_use_the_default()
    {
        IniFile ini = Read("[S]\nA =\n");

        Assert.Equal(7, ini.Whole("S", "A", 7, 0, 10));
        Assert.Equal(8, ini.Whole("S", "B", 8, 0, 10));
        Assert.Empty(ini.Complaints);
    }

    [Theory]
    [InlineData("bmp", ImageFormat.Bmp, 0)]
    [InlineData("BMP", ImageFormat.Bmp, 0)]
    [InlineData("1", ImageFormat.Png, 1)]
    [InlineData("png,bmp", ImageFormat.Png, 1)]
    [InlineData("tiff", ImageFormat.Png, 1)]
    public void Choice_accepts_names_only(string text, ImageFormat expected, int complaints)
    {
        IniFile ini = Read($"[S]\nA = {text}\n");

        Assert.Equal(expected, ini.Choice("S", "A", ImageFormat.Png, "PNG or BMP"));
        Assert.Equal(complaints, ini.Complaints.Count);
    }

    [Fact]
    public void Choices_are_a_list_and_one_bad_name_gives_the_default()
    {
        ObjectClass[] fallback = [ObjectClass.Other];
        IniFile ini = Read("[S]\nA = car, Truck\nB = car, lorry\n");

        Assert.Equal([ObjectClass.Car, ObjectClass.Truck], ini.Choices("S", "A", fallback, "classes"));
        Assert.Equal(fallback, ini.Choices("S", "B", fallback, "classes"));
        Assert.Single(ini.Complaints);
    }

    [Fact]
    public void Unknown_repeated_and_broken_lines_are_reported_in_order()
    {
        IniFile ini = Read("[S]\nnonsense\nA = 1\nTypo = 2\nA = 3\n");
        Assert.Equal(1, ini.Whole("S", "A", 0, 0, 10));

        Assert.Equal(
            [
                "Line 2: 'nonsense' is not of the form Name = value.",
                "Line 4: there is no setting [S] Typo.",
                "Line 5: [S] A is already set in line 3; that value is used.",
            ],
            ini.Complaints
        );
    }

    private static IniFile Read(string text) => IniFile.Read(new StringReader(text));
}
