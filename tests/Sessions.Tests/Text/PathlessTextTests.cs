using Harvester.Sessions.Text;

namespace Harvester.Sessions.Tests.Text;

public sealed class PathlessTextTests
{
    [Theory]
    [InlineData("The session in '/home/ann/night 1' cannot be written: no.", "The session in 'night 1' cannot be written: no.")]
    [InlineData("'../ann/out' is full.", "'out' is full.")]
    [InlineData(@"Access to the path 'C:\Users\Ann B\out\7.png' is denied.", "Access to the path '7.png' is denied.")]
    [InlineData(@"'\\box\share\Ann\' is gone.", "'Ann' is gone.")]
    [InlineData("No space left on device : /mnt/ann/out/7.png", "No space left on device : 7.png")]
    [InlineData(@"Could not open D:\ann\7.png", "Could not open 7.png")]
    [InlineData("Cannot open (/mnt/ann/7.png).", "Cannot open (7.png).")]
    public void Path_is_replaced_by_its_last_name(string message, string kept) => Assert.Equal(kept, PathlessText.Of(message));

    [Theory]
    [InlineData("")]
    [InlineData("The disk is full.")]
    [InlineData("The field 'a' is at 60 frames/s in 'b'.")]
    [InlineData("The error is 1/2 px, at 60 frames/s and/or less.")]
    [InlineData("It's the game's fault: 3 px isn't 2.")]
    public void Text_without_paths_stays(string message) => Assert.Equal(message, PathlessText.Of(message));

    [Fact]
    public void No_text_stays_none() => Assert.Null(PathlessText.Of(null));
}
