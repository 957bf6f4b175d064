using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using System.Text.Json;

namespace Harvester.Mod.Tests.Gym;

/// <summary>The process of drive_the_mod.py, and the lines that it has printed.</summary>
internal sealed class PythonDriver : IDisposable
{
    private readonly ConcurrentQueue<JsonElement> _lines = new();
    private readonly ConcurrentQueue<string> _errors = new();
    private readonly Process _process;

    public PythonDriver(int port, int steps)
    {
        var start = new ProcessStartInfo(
            PythonFactAttribute.Command,
            [
                Path.Combine(BuiltMod.RepositoryRoot, "tests", "Mod.Tests", "Gym", "drive_the_mod.py"),
                port.ToString(CultureInfo.InvariantCulture),
                steps.ToString(CultureInfo.InvariantCulture),
            ]
        )
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["PYTHONPATH"] = Path.Combine(BuiltMod.RepositoryRoot, "python", "src");
        start.Environment["PYTHONDONTWRITEBYTECODE"] = "1";
        _process = Process.Start(start)!;
        _process.OutputDataReceived += (_, line) =>
        {
            if (line.Data is { } text)
            {
                _lines.Enqueue(JsonDocument.Parse(text).RootElement);
            }
        };
        _process.ErrorDataReceived += (_, line) => _errors.Enqueue(line.Data ?? "");
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    public IReadOnlyList<JsonElement> Lines => [.. _lines];

    public string Errors => string.Join('\n', _errors).Trim();

    public bool HasExited => _process.HasExited;

    /// <summary>Reads all that is left of an ended process.</summary>
    /// <returns>Its exit code.</returns>
    public int Finish()
    {
        _process.WaitForExit();
        return _process.ExitCode;
    }

    public void Dispose()
    {
        if (!_process.HasExited)
        {
            _process.Kill();
        }

        _process.Dispose();
    }
}
