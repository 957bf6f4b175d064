using Harvester.Exports.Formats;
using Harvester.Exports.Validation;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

[Collection(SimulatedSession.Collection)]
public sealed class DatasetValidatorTests(SimulatedSession simulated) : ExportTests
{
    public static TheoryData<string> Formats =>
        [.. DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name)];

    [Theory]
    [MemberData(nameof(Formats))]
    public void Validate_of_an_export_finds_nothing(string format)
    {
        Folder.Export(format, simulated.OpenFor(format));

        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void Validate_of_an_export_of_two_split_sessions_finds_nothing(string format)
    {
        Folder.Export(
            format,
            [simulated.OpenFor(format), simulated.OpenFor(format)],
            new ExportOptions { Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 1, 1) }
        );

        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Validate_counts_frames()
    {
        Folder.Export("voc", simulated.Open());

        Assert.Equal(
            ("voc", SimulatedSession.Frames),
            (DatasetValidator.Validate(Folder.PathOf("out")).Format, DatasetValidator.Validate(Folder.PathOf("out")).Frames)
        );
    }

    [Fact]
    public void Validate_reports_a_malformed_manifest()
    {
        Folder.Export("voc", simulated.Open());
        File.WriteAllText(Folder.PathOf("out/export.json"), "{\"plan\":{}}");

        Assert.Throws<DatasetFormatException>(() => DatasetValidator.Validate(Folder.PathOf("out")));
    }
}
