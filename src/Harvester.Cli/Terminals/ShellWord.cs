using System;
using System.Linq;

namespace Harvester.Cli.Terminals;

/// <summary>A word as it must be typed in a shell.</summary>
internal static class ShellWord
{
    private const string PlainLetters = "/._-+:,@";

    /// <summary>The word, in quotes where the shell would otherwise split or change it.</summary>
    /// <param name="word">What the command is to get.</param>
    /// <param name="isWindows">Whether for cmd and PowerShell, whose quotes are double; else for a POSIX shell.</param>
    public static string Of(string word, bool isWindows)
    {
        bool isPlain = word.Length > 0
            && word.All(letter => char.IsAsciiLetterOrDigit(letter) || PlainLetters.Contains(letter) || (isWindows && letter == '\\'));
        return isPlain ? word
            : isWindows ? $"\"{word}\""
            : $"'{word.Replace("'", @"'\''", StringComparison.Ordinal)}'";
    }

    /// <summary>The word for the usual shell of this system.</summary>
    public static string Of(string word) => Of(word, OperatingSystem.IsWindows());
}
