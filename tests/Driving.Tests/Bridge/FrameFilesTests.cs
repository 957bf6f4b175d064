using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class FrameFilesTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-frames").FullName;
    private readonly FrameFiles _files;

    public FrameFilesTests() => _files = new FrameFiles(_folder);

    [Fact]
    public void Failed_frame_write_is_retried()
    {
        Directory.CreateDirectory(PathOf("state.txt"));
        _files.Put(Frames.State(3), Frames.Picture(3));
        Assert.ThrowsAny<IOException>(_files.Write);
        Directory.Delete(PathOf("state.txt"));
        _files.Write();

        Assert.Contains("frame_00000003.png", File.ReadAllText(PathOf("state.txt")), StringComparison.Ordinal);
        Assert.Equal(["frame_00000003.png", "state.txt"], Directory.GetFiles(_folder).Select(Path.GetFileName).Order());
    }

    [Fact]
    public void Newer_frame_replaces_one_that_could_not_be_written()
    {
        Directory.CreateDirectory(PathOf("frame_00000003.png"));
        _files.Put(Frames.State(3), Frames.Picture(3));
        Assert.ThrowsAny<IOException>(_files.Write);
        _files.Put(Frames.State(4), Frames.Picture(4));
        _files.Write();

        Assert.Contains("frame_00000004.png", File.ReadAllText(PathOf("state.txt")), StringComparison.Ordinal);
    }

    [Fact]
    public void Pictures_of_earlier_drives_are_deleted_and_other_files_kept()
    {
        string[] others =
        [
            "frame_0000001.png",
            "frame_000000012.png",
            "frame_0000000a.png",
            "frame_00000001.png.bak",
            "my_frame_00000001.png",
            "00000001.png",
        ];
        string[] earlier = ["frame_00000000.png", "frame_00000123.png", "frame_99999999.png"];
        Assert.All([.. others, .. earlier], name => File.WriteAllText(PathOf(name), ""));
        _files.DeleteEarlier();

        Assert.Equal(others.Order(), Directory.GetFiles(_folder).Select(Path.GetFileName).Order());
    }

    [Fact]
    public void Deleted_folder_is_recreated()
    {
        Write(0, 12);
        Directory.Delete(_folder, recursive: true);
        Write(12, 24);

        Assert.Equal(10, Directory.GetFiles(_folder, "frame_*.png").Length);
    }

    [Fact]
    public void Undeletable_pictures_do_not_fill_the_disk_and_are_retried()
    {
        for (int frame = 0; frame < 100; frame++)
        {
            // A picture becomes what File.Delete does not delete.
            Write(frame, frame + 1);
            File.Delete(PictureOf(frame));
            Directory.CreateDirectory(PictureOf(frame));
        }

        Assert.Throws<BridgeException>(() => Write(100, 101));
        Assert.False(File.Exists(PictureOf(100)));

        for (int frame = 0; frame < 100; frame++)
        {
            Directory.Delete(PictureOf(frame));
        }

        Write(100, 130);
        Assert.Equal(Enumerable.Range(120, 10).Select(PictureOf), Directory.GetFiles(_folder, "frame_*.png").Order());
    }

    public void Dispose()
    {
        _files.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    private void Write(int from, int end)
    {
        for (int frame = from; frame < end; frame++)
        {
            _files.Put(Frames.State(frame), Frames.Picture(1));
            _files.Write();
        }
    }

    private string PathOf(string name) => Path.Combine(_folder, name);

    private string PictureOf(int frame) => PathOf(FormattableString.Invariant($"frame_{frame:00000000}.png"));
}
