using System.IO.Compression;
using Harvester.Datasets.Diagnosis;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.SelfTests;

namespace Harvester.Datasets.Tests.Diagnosis;

/// <summary>The doctor reads the result of the mod's self-test, alone and in its zip.</summary>
public sealed class SelfTestDoctorTests : IDisposable
{
    private const string Text = """
        {"formatVersion":1,"kind":"selfTest","tool":"mod 1","game":"GTA V","isComplete":true,"checks":[
        {"check":"window","verdict":"good","finding":"Pictures show the game's window."},
        {"check":"lag","verdict":"note","finding":"The picture is 2 ticks behind."},
        {"check":"hud","verdict":"problem","finding":"The game's display stays."}],
        "changedSettings":{"Freeze":"TimeScale"},"pictures":[]}
        """;

    private readonly string _folder = Directory.CreateTempSubdirectory("selftest").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Each_line_is_read_and_each_problem_has_advice()
    {
        Harvester.Datasets.Diagnosis.Diagnosis found = Doctor.Examine(Written(SelfTestJson.FileName, Text));

        Assert.Equal(["window", "lag", "hud"], found.SelfTest!.Lines.Select(line => line.Check));
        Assert.Equal(["Freeze = TimeScale"], found.SelfTest.Changes);
        Finding problem = Assert.Single(found.Findings);
        Assert.Equal("The game's display stays.", problem.Cause);
        Assert.Contains("radar", problem.Advice, StringComparison.Ordinal);
    }

    [Fact]
    public void Zip_gives_what_the_file_gives() =>
        Assert.Equal("mod 1", Doctor.Examine(Zipped(SelfTestJson.FileName, Text)).SelfTest!.Tool);

    [Fact]
    public void Every_check_has_advice() =>
        Assert.All(
            SelfTestChecks.All.Except([SelfTestChecks.Cost]),
            check => Assert.DoesNotContain("Report it", Harvester.Datasets.Diagnosis.Diagnosis.AdviceFor(check), StringComparison.Ordinal)
        );

    [Theory]
    [InlineData("")]
    [InlineData("[]")]
    [InlineData("{}")]
    [InlineData("{\"formatVersion\":2,\"kind\":\"selfTest\"}")]
    [InlineData("{\"formatVersion\":1,\"kind\":\"selfTest\",\"tool\":\"\",\"game\":\"\",\"isComplete\":true,\"checks\":[7]}")]
    public void Damaged_file_is_refused(string text)
    {
        Assert.Throws<DatasetFormatException>(() => Doctor.Examine(Written(SelfTestJson.FileName, text)));
        Assert.Throws<DatasetFormatException>(() => Doctor.Examine(Zipped(SelfTestJson.FileName, text)));
    }

    [Fact]
    public void Zip_without_a_result_is_refused() =>
        Assert.Throws<DatasetFormatException>(() => Doctor.Examine(Zipped("other.json", Text)));

    [Fact]
    public void Broken_zip_is_refused()
    {
        string path = Zipped(SelfTestJson.FileName, Text);
        byte[] whole = File.ReadAllBytes(path);
        for (int length = 0; length < whole.Length; length += 7)
        {
            File.WriteAllBytes(path, whole[..length]);
            Assert.Throws<DatasetFormatException>(() => Doctor.Examine(path));
        }
    }

    [Fact]
    public void Changed_byte_of_a_zip_is_read_or_refused()
    {
        string path = Zipped(SelfTestJson.FileName, Text);
        byte[] whole = File.ReadAllBytes(path);
        for (int at = 0; at < whole.Length; at++)
        {
            byte[] changed = [.. whole];
            changed[at] ^= 0x55;
            File.WriteAllBytes(path, changed);
            try
            {
                Doctor.Examine(path);
            }
            catch (DatasetFormatException e)
            {
                Assert.Contains("self-test", e.Message, StringComparison.Ordinal);
            }
        }
    }

    private string Written(string name, string text)
    {
        string path = Path.Combine(_folder, name);
        File.WriteAllText(path, text);
        return path;
    }

    private string Zipped(string entry, string text)
    {
        string path = Path.Combine(_folder, "selftest-20260101-120000.zip");
        File.Delete(path);
        using ZipArchive zip = ZipFile.Open(path, ZipArchiveMode.Create);
        using var writer = new StreamWriter(zip.CreateEntry(entry).Open());
        writer.Write(text);
        return path;
    }
}
