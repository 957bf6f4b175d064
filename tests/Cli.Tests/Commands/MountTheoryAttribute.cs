using System.Diagnostics;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A test that mounts a disk in a namespace of its own; it is skipped where the system does not let users do that.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class MountTheoryAttribute : TheoryAttribute
{
    public MountTheoryAttribute() =>
        Skip =
            !OperatingSystem.IsLinux() ? "Mounts a disk, which is tested on Linux."
            : CanMount() ? null
            : "Needs unshare and the right to mount a tmpfs in a user namespace.";

    private static bool CanMount()
    {
        try
        {
            var start = new ProcessStartInfo("unshare", ["-rm", "mount", "-t", "tmpfs", "tmpfs", "/tmp"]) { RedirectStandardError = true };
            using Process mount = Process.Start(start)!;
            mount.StandardError.ReadToEnd();
            mount.WaitForExit();
            return mount.ExitCode == 0;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return false;
        }
    }
}
