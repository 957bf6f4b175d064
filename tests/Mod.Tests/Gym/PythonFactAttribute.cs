using System.ComponentModel;
using System.Diagnostics;

namespace Harvester.Mod.Tests.Gym;

/// <summary>A test that needs Python with NumPy; it is skipped, with a message, where that is not installed.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class PythonFactAttribute : FactAttribute
{
    private const string Debians = "/usr/bin/python3";

    public PythonFactAttribute()
    {
        Skip = HasNumPy() ? null : "Needs python3 with numpy.";
    }

    public static string Command { get; } = File.Exists(Debians) ? Debians : "python3";

    private static bool HasNumPy()
    {
        try
        {
            using Process python = Process.Start(new ProcessStartInfo(Command, ["-c", "import numpy"]) { RedirectStandardError = true })!;
            python.StandardError.ReadToEnd();
            python.WaitForExit();
            return python.ExitCode == 0;
        }
        catch (Win32Exception)
        {
            return false;
        }
    }
}
