using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Columns;

public sealed class ParquetCheckTests(SimulatedSession simulated) : CheckTests(simulated, "parquet")
{
    [Fact]
    public void Good_export_has_no_problem()
    {
        Export(TwoSplits);
        Assert.Empty(Problems());
    }

    [Fact]
    public void Missing_table_is_found() => AssertLossIsFound("objects.parquet", "objects.parquet: it is missing.");

    [Fact]
    public void Missing_image_is_found() => AssertLossIsFound("images/00000002.png", "frames.parquet: frame 2 has no image");

    [Fact]
    public void Another_table_is_found()
    {
        Export();
        File.Copy(Folder.PathOf("out/lanes.parquet"), Folder.PathOf("out/objects.parquet"), overwrite: true);
        AssertFound("objects.parquet: its columns are not those of the format.");
    }

    [Fact]
    public void Rows_of_unknown_frames_are_found()
    {
        Export();
        Folder.Export("parquet", Session.Open(), Copied, "short");
        File.Copy(Folder.PathOf("short/frames.parquet"), Folder.PathOf("out/frames.parquet"), overwrite: true);
        AssertFound("objects.parquet: it has a row of frame 3, which is not in frames.parquet.");
    }

    [Fact]
    public void Cut_off_table_is_found()
    {
        Export();
        using (FileStream file = File.Open(Folder.PathOf("out/frames.parquet"), FileMode.Open))
        {
            file.SetLength(file.Length - 1);
        }

        AssertFound("frames.parquet: it is no Parquet file, or it is cut off.");
    }

    [Theory]
    [InlineData(0x19, "frames.parquet: its footer is nested too deeply")]
    [InlineData(0x1C, "frames.parquet: its footer is nested too deeply")]
    [InlineData(0xFF, "frames.parquet: its footer has a field of the unknown type 15.")]
    public void Hostile_footer_is_refused(byte repeated, string expected)
    {
        Export();

        // 0x19: field 1, a list of one list, and so on; 0x1C: field 1, a structure whose field 1 is a structure, and so on.
        byte[] footer = [.. Enumerable.Repeat(repeated, 100_000)];
        byte[] mark = "PAR1"u8.ToArray();
        File.WriteAllBytes(Folder.PathOf("out/frames.parquet"), [.. mark, .. footer, .. BitConverter.GetBytes(footer.Length), .. mark]);

        AssertFound(expected);
    }

    [Fact]
    public void Any_changed_byte_is_a_problem()
    {
        Export();
        string path = Folder.PathOf("out/frames.parquet");
        byte[] good = File.ReadAllBytes(path);

        // Every 97th byte: pages, their headers, and the footer.
        for (int i = 0; i < good.Length; i += 97)
        {
            byte[] bad = [.. good];
            bad[i] ^= 0x55;
            File.WriteAllBytes(path, bad);
            Assert.NotEmpty(Problems());
        }
    }
}
