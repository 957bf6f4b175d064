using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Tapes;

namespace Harvester.Mod;

/// <summary>Records the calls to the game on a tape.</summary>
/// <param name="game">The game.</param>
/// <param name="tape">The recording.</param>
internal sealed class TapedApi(IGameApi game, TapeRecorder tape) : IGameApi
{
    /// <inheritdoc/>
    public T Call<T>(Hash native, NativeArgument[] arguments)
    {
        T result = default!;
        Record(
            native,
            arguments,
            () =>
            {
                result = game.Call<T>(native, arguments);
                return TapedCall.Recorded(result);
            }
        );
        return result;
    }

    /// <inheritdoc/>
    public void Call(Hash native, NativeArgument[] arguments) =>
        Record(
            native,
            arguments,
            () =>
            {
                game.Call(native, arguments);
                return default;
            }
        );

    /// <inheritdoc/>
    public int[] Nearby(EntityKind kind, Vector3D centre, double radius, IReadOnlyList<int> models)
    {
        int[] handles = [];
        Record(
            TapedCall.TargetOf(kind),
            TapedCall.Asked(centre, radius, models),
            () =>
            {
                handles = game.Nearby(kind, centre, radius, models);
                return default;
            },
            () => [handles]
        );
        return handles;
    }

    private void Record(Hash native, NativeArgument[] arguments, Func<TapeValue> call)
    {
        if (!tape.IsOn || TapedCall.IsLeftOut(native))
        {
            call();
            return;
        }

        // What memory holds is asked before the call, because natives read it too.
        Record(
            (ulong)native,
            [.. arguments.Select(argument => argument.Recorded)],
            call,
            () => [.. arguments.Select(argument => argument.Output).OfType<NativeOutput>().Select(output => output.Slots)]
        );
    }

    private void Record(ulong target, TapeValue[] asked, Func<TapeValue> call, Func<int[][]> written)
    {
        TapeValue answer;
        try
        {
            answer = call();
        }
        catch (Exception exception) when (exception is not ThreadAbortException)
        {
            tape.Call(new TapeCall(target, asked, TapeValue.Failed(exception), []));
            throw;
        }

        tape.Call(new TapeCall(target, asked, answer, written()));
    }
}
