using System.Reflection;
using System.Runtime.InteropServices;

namespace Harvester.Cli.Terminals;

/// <summary>Keeps the details of an unexpected exception, so that it can be reported.</summary>
internal static class FaultReport
{
    /// <summary>Writes the details to a new file in the system's temporary folder.</summary>
    /// <returns>One line for the user, which names the file.</returns>
    public static string Write(Exception fault)
    {
        string what = $"Internal error: {fault.GetType().Name}.";
        try
        {
            string folder = Directory.CreateTempSubdirectory("harvester-fault-").FullName;
            string file = Path.Combine(folder, "details.txt");
            File.WriteAllText(file, Details(fault));
            return $"{what} Please report it with '{file}', which has the details.";
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return $"{what} Please report it: {fault.StackTrace?.Split('\n').FirstOrDefault()?.Trim() ?? "no details are available"}.";
        }
    }

    private static string Details(Exception fault) =>
        string.Join(
            '\n',
            $"harvester {typeof(FaultReport).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion}",
            $"{RuntimeInformation.OSDescription}, {RuntimeInformation.FrameworkDescription}",
            fault.ToString(),
            ""
        );
}
