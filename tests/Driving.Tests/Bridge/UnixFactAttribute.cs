namespace Harvester.Driving.Tests.Bridge;

/// <summary>A test that starts programs of the shell.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class UnixFactAttribute : FactAttribute
{
    public UnixFactAttribute()
    {
        if (OperatingSystem.IsWindows())
        {
            Skip = "There is no /bin/sh.";
        }
    }
}
