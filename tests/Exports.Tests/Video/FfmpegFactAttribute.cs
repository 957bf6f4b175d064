namespace Harvester.Exports.Tests.Video;

/// <summary>A test that needs the program ffmpeg; where it is not installed, it is skipped and says so.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class FfmpegFactAttribute : FactAttribute
{
    public FfmpegFactAttribute()
    {
        if (!FfmpegProgram.IsThere)
        {
            Skip = "ffmpeg is not installed; install it to run this test.";
        }
    }
}
