using System.Text;
using System.Xml;
using Harvester.Play.Settings;

namespace Harvester.Play.Tests.Settings;

/// <summary>The game's settings.xml, whole and damaged.</summary>
public sealed class GraphicsSettingsTests : IDisposable
{
    private const string Whole = """
        <?xml version="1.0" encoding="UTF-8"?>

        <Settings>
          <version value="27" />
          <configSource>SMC_USER</configSource>
          <graphics>
            <MSAA value="4" />
            <TXAA_Enabled value="true" />
            <PostFX value="3" />
            <DoF value="true" />
            <MotionBlurStrength value="1.000000" />
          </graphics>
          <video>
            <PauseOnFocusLoss value="1" />
          </video>
          <VideoCardDescription>A card</VideoCardDescription>
        </Settings>
        """;

    private readonly string _folder = Directory.CreateTempSubdirectory("settings").FullName;

    private string Path => System.IO.Path.Combine(_folder, "settings.xml");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Values_of_a_whole_file_are_read()
    {
        GraphicsSettings settings = Read(Whole);

        Assert.Equal(
            (1, true, 4, true, 3, true),
            (settings.MotionBlur, settings.DepthOfField, settings.Msaa, settings.Txaa, settings.PostFx, settings.PausesWithoutFocus)
        );
        Assert.Equal(
            ["Motion Blur Strength is 1", "In-Game Depth Of Field Effects is on", "MSAA is 4", "TXAA is on", "Post FX is above Normal (3)"],
            settings.Harmful
        );
    }

    [Theory]
    [InlineData("<Settings/>")]
    [InlineData("<Settings><DoF/><MSAA value=\"\"/><PostFX value=\"many\"/><TXAA_Enabled value=\"yes\"/></Settings>")]
    [InlineData("<Settings><MotionBlurStrength value=\"NaN\"/></Settings>")]
    [InlineData("<Settings><MSAA value=\"-1\"/><PostFX value=\"0\"/></Settings>")]
    public void Absent_and_unknown_values_are_not_harmful(string xml) => Assert.Empty(Read(xml).Harmful);

    [Theory]
    [InlineData("")]
    [InlineData("milk")]
    [InlineData("<Settings>")]
    [InlineData("<!DOCTYPE s><s/>")]
    [InlineData("<!DOCTYPE s [<!ENTITY a SYSTEM \"file:///etc/hostname\">]><s>&a;</s>")]
    [InlineData("<!DOCTYPE s [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]><s>&b;</s>")]
    public void Malformed_file_and_document_type_are_refused(string xml) => Assert.Throws<XmlException>(() => Read(xml));

    [Fact]
    public void File_cut_off_anywhere_is_refused()
    {
        byte[] whole = Encoding.UTF8.GetBytes(Whole);
        for (int length = 0; length < whole.Length; length++)
        {
            File.WriteAllBytes(Path, whole[..length]);
            Assert.Throws<XmlException>(() => GraphicsSettingsFile.Read(Path));
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Damaged_bytes_are_read_or_refused_in_one_line()
    {
        const int cases = 5_000;
        var random = new Random(1);
        int refused = 0;
        for (int i = 0; i < cases; i++)
        {
            byte[] bytes = Encoding.UTF8.GetBytes(Whole);
            for (int damage = random.Next(1, 6); damage > 0; damage--)
            {
                bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            }

            File.WriteAllBytes(Path, bytes);
            try
            {
                Assert.All(GraphicsSettingsFile.Read(Path).Harmful, text => Assert.InRange(text.Length, 1, 80));
            }
            catch (XmlException exception)
            {
                refused++;
                Assert.DoesNotContain('\n', exception.Message);
            }
        }

        Assert.InRange(refused, 1, cases - 1);
    }

    [Fact]
    public void Deeply_nested_file_is_read()
    {
        const int depth = 50_000;
        string nested = string.Concat(Enumerable.Repeat("<a>", depth)) + string.Concat(Enumerable.Repeat("</a>", depth));

        Assert.Empty(Read(nested).Harmful);
    }

    [Fact]
    public void File_that_is_too_long_missing_or_a_folder_is_refused()
    {
        using (var file = new FileStream(Path, FileMode.Create))
        {
            const long sparse = 8L * 1024 * 1024 * 1024;
            file.SetLength(sparse);
        }

        IOException refused = Assert.Throws<IOException>(() => GraphicsSettingsFile.Read(Path));
        Assert.Contains("longer than 1 MiB", refused.Message, StringComparison.Ordinal);
        File.Delete(Path);
        Assert.Throws<FileNotFoundException>(() => GraphicsSettingsFile.Read(Path));
        Directory.CreateDirectory(Path);
        Assert.Throws<UnauthorizedAccessException>(() => GraphicsSettingsFile.Read(Path));
    }

    [Fact]
    public void Each_edition_has_a_folder_of_its_own()
    {
        Assert.EndsWith(System.IO.Path.Combine("Rockstar Games", "GTA V", "settings.xml"), GraphicsSettingsFile.PathOf(false));
        Assert.EndsWith(System.IO.Path.Combine("Rockstar Games", "GTAV Enhanced", "settings.xml"), GraphicsSettingsFile.PathOf(true));
    }

    private GraphicsSettings Read(string text)
    {
        File.WriteAllText(Path, text);
        return GraphicsSettingsFile.Read(Path);
    }
}
