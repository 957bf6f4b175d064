namespace Harvester.Runs.Supervising;

/// <summary>Quotes words for a shell.</summary>
public static class ShellWord
{
    private const string PlainLetters = "/._-+:,@";

    /// <summary>The word, quoted if the shell would otherwise split or change it.</summary>
    /// <param name="word">The argument that the command is to receive.</param>
    /// <param name="isWindows">Whether the shell is cmd or PowerShell, which use double quotes; otherwise a POSIX shell.</param>
    public static string Of(string word, bool isWindows)
    {
        bool isPlain =
            word.Length > 0
            && word.All(letter => char.IsAsciiLetterOrDigit(letter) || PlainLetters.Contains(letter) || (isWindows && letter == '\\'));
        return isPlain ? word
            : isWindows ? $"\"{word}\""
            : $"'{word.Replace("'", @"'\''", StringComparison.Ordinal)}'";
    }

    /// <summary>The word, quoted for the usual shell of this system.</summary>
    public static string Of(string word) => Of(word, OperatingSystem.IsWindows());
}
