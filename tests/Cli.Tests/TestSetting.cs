using System.Globalization;

namespace Harvester.Cli.Tests;

/// <summary>Settings of tests in environment variables.</summary>
internal static class TestSetting
{
    /// <summary>A whole number that is not negative.</summary>
    /// <param name="variable">The environment variable.</param>
    /// <param name="usual">The number where the variable is not set.</param>
    public static int Number(string variable, int usual) =>
        int.TryParse(Environment.GetEnvironmentVariable(variable), NumberStyles.None, CultureInfo.InvariantCulture, out int value)
            ? value
            : usual;
}
