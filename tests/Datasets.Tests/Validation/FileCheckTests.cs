using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Images and masks that are gone, damaged, of the wrong kind or not where they may be.</summary>
public sealed class FileCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Validate_finds_a_missing_image()
    {
        File.Delete(_session.PathOf("frames/00000001.png"));

        _session.AssertProblem(2, "image 'frames/00000001.png' is missing");
    }

    [Fact]
    public void Validate_finds_a_missing_mask()
    {
        File.Delete(_session.PathOf("masks/00000002.png"));

        _session.AssertProblem(3, "mask 'masks/00000002.png' is missing");
    }

    [Fact]
    public void Validate_finds_an_image_of_another_size()
    {
        File.WriteAllBytes(_session.PathOf("frames/00000000.png"), TestImages.Png(81, 60));

        _session.AssertProblem(1, "is 81 x 60, but its label says 80 x 60");
    }

    [Fact]
    public void Validate_finds_a_mask_of_another_size()
    {
        File.WriteAllBytes(_session.PathOf("masks/00000000.png"), TestImages.Png(80, 61, 16, 0));

        _session.AssertProblem(1, "is 80 x 61, but its label says 80 x 60");
    }

    [Fact]
    public void Validate_finds_a_mask_of_8_bits()
    {
        File.WriteAllBytes(_session.PathOf("masks/00000000.png"), TestImages.Png(80, 60, 8, 0));

        _session.AssertProblem(1, "has 8 bits per pixel instead of 16");
    }

    [Fact]
    public void Validate_finds_a_truncated_image()
    {
        File.WriteAllBytes(_session.PathOf("frames/00000000.png"), TestImages.Png(80, 60)[..40]);

        _session.AssertProblem(1, "cut off");
    }

    [Fact]
    public void Validate_finds_a_file_that_is_not_an_image()
    {
        File.WriteAllText(_session.PathOf("frames/00000000.png"), "not an image");

        _session.AssertProblem(1, "not a PNG, BMP or JPEG");
    }

    [Theory]
    [InlineData("../frames/00000000.png")]
    [InlineData("frames\\..\\..\\x.png")]
    [InlineData("/etc/passwd.png")]
    public void Validate_finds_a_path_outside_the_session(string path)
    {
        _session.Lines[0]["image"] = path;

        _session.AssertProblem(1, "points outside the session");
    }

    [Fact]
    public void Validate_finds_an_image_named_twice()
    {
        _session.Lines[1]["image"] = "frames/00000000.png";

        _session.AssertProblem(2, "is already used by an earlier line");
    }
}
