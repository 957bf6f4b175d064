using System.Net.Sockets;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Lets TCP check whether the other machine still answers, even while nothing is sent, as in a paused game: a machine that was switched off
/// or cut off sends no notice.
/// </summary>
internal static class KeepAlive
{
    private const int QuietSeconds = 5;
    private const int SecondsBetweenQuestions = 1;
    private const int QuestionsWithoutAnswer = 5;

    // These numbers are the same on all systems; .NET Framework has no names for them.
    private const SocketOptionName Time = (SocketOptionName)3;
    private const SocketOptionName RetryCount = (SocketOptionName)16;
    private const SocketOptionName Interval = (SocketOptionName)17;

    /// <summary>Enables keep-alive. A system on which the interval cannot be set uses its own.</summary>
    public static void Ask(Socket socket)
    {
        socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive, true);
        try
        {
            socket.SetSocketOption(SocketOptionLevel.Tcp, Time, QuietSeconds);
            socket.SetSocketOption(SocketOptionLevel.Tcp, Interval, SecondsBetweenQuestions);
            socket.SetSocketOption(SocketOptionLevel.Tcp, RetryCount, QuestionsWithoutAnswer);
        }
        catch (SocketException)
        {
            // Windows before 10 (1709).
            return;
        }
    }
}
