using System.Text;
using Harvester.Runs.Driving;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Tests.Driving;

public sealed class DriveMarkTests : IDisposable
{
    private const string Command = "harvester drive --record session --out out";
    private static readonly byte[] First = Encoding.UTF8.GetBytes("the first");
    private static readonly byte[] Second = Encoding.UTF8.GetBytes("the second");

    private readonly TemporaryFolder _folder = new();
    private readonly DriveMark _noted;

    public DriveMarkTests()
    {
        Directory.CreateDirectory(Session);
        Directory.CreateDirectory(_folder.PathOf("out"));
        UnfinishedMark.Write(Session, Command);
        _noted = new DriveMark(Session, Command, _folder.PathOf("out"));
    }

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Drive_that_was_noted_is_known_and_no_other()
    {
        Assert.False(_noted.IsThere());
        Write(First);
        Assert.False(_noted.IsThere());
        _noted.Note(First);
        Assert.True(_noted.IsThere());
        Write(Second);
        Assert.False(_noted.IsThere());
        Assert.Equal(Command, UnfinishedMark.CommandIn(Session));
    }

    [Fact]
    public void Drive_is_known_until_the_next_one_has_replaced_it()
    {
        _noted.Note(First);
        Write(First);
        _noted.Note(Second);
        Assert.True(_noted.IsThere());
        Write(Second);
        Assert.True(_noted.IsThere());
    }

    [Fact]
    public void Drive_of_another_command_is_not_known()
    {
        _noted.Note(First);
        Write(First);

        Assert.False(new DriveMark(Session, Command + "2", _folder.PathOf("out")).IsThere());
        UnfinishedMark.Delete(Session);
        Assert.False(_noted.IsThere());
        _noted.Note(First);
        Assert.False(UnfinishedMark.IsIn(Session));
    }

    private void Write(byte[] record) => File.WriteAllBytes(_folder.PathOf("out/drive.json"), record);
}
