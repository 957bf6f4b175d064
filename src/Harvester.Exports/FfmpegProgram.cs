using System.ComponentModel;
using System.Diagnostics;

namespace Harvester.Exports;

/// <summary>The program ffmpeg, which the user installs.</summary>
internal static class FfmpegProgram
{
    /// <summary>Its name.</summary>
    public const string Name = "ffmpeg";

    /// <summary>The most characters of a message of the program that are repeated.</summary>
    private const int MaxMessage = 300;

    /// <summary>Refuses a format whose program is not installed.</summary>
    /// <exception cref="FileNotFoundException">It is not.</exception>
    public static void CheckFor(DatasetFormat format)
    {
        if (format.Program is not null && !IsThere)
        {
            throw new FileNotFoundException(
                $"The format {format.Name} needs the program {Name}, which is not installed. Install it, for example with "
                    + $"'apt install {Name}', so that it is found by its name, or choose another format."
            );
        }
    }

    /// <summary>Whether it is installed.</summary>
    public static bool IsThere
    {
        get
        {
            try
            {
                using Process process = Process.Start(StartOf(["-version"]))!;
                process.StandardInput.Close();
                _ = process.StandardError.ReadToEndAsync();
                process.StandardOutput.ReadToEnd();
                process.WaitForExit();
                return process.ExitCode == 0;
            }
            catch (Win32Exception)
            {
                return false;
            }
        }
    }

    /// <summary>Runs it.</summary>
    /// <param name="words">The words of its command line.</param>
    /// <param name="feed">Writes its standard input.</param>
    /// <exception cref="IOException">It failed; the message has what it says.</exception>
    public static void Run(IReadOnlyList<string> words, Action<Stream> feed)
    {
        using Process process = Process.Start(StartOf(words))!;
        try
        {
            Task<string> errors = process.StandardError.ReadToEndAsync();
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            IOException? broken = null;
            try
            {
                feed(process.StandardInput.BaseStream);
                process.StandardInput.Close();
            }
            catch (IOException e)
            {
                // It has ended before it read everything; what it says is the reason.
                broken = e;
            }

            process.WaitForExit();
            _ = output.GetAwaiter().GetResult();
            if (process.ExitCode != 0 || broken is not null)
            {
                string message = string.Join(' ', errors.GetAwaiter().GetResult().Split('\n', StringSplitOptions.TrimEntries));
                throw new IOException(
                    $"{Name} failed with exit code {process.ExitCode}: {message[..Math.Min(MaxMessage, message.Length)].Trim()}",
                    broken
                );
            }
        }
        finally
        {
            if (!process.HasExited)
            {
                process.Kill();
            }
        }
    }

    private static ProcessStartInfo StartOf(IEnumerable<string> words)
    {
        var start = new ProcessStartInfo(Name)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            UseShellExecute = false,
        };
        foreach (string word in words)
        {
            start.ArgumentList.Add(word);
        }

        return start;
    }
}
