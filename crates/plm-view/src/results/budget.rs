//! How much memory a file may take that is read.

/// Bytes that reading may still take.
pub(super) struct Budget {
    most: usize,
    left: usize,
}

impl Budget {
    pub(super) fn new(most: usize) -> Self {
        Self { most, left: most }
    }

    /// Takes so many bytes.
    ///
    /// # Errors
    /// If they are more than the rest; then nothing is taken.
    pub(super) fn take(&mut self, bytes: usize) -> Result<(), String> {
        self.left = self.left.checked_sub(bytes).ok_or_else(|| self.too_large())?;
        Ok(())
    }

    /// Takes bytes for as long as something is done.
    ///
    /// # Errors
    /// As [`take`](Self::take).
    pub(super) fn meanwhile<T>(
        &mut self,
        bytes: usize,
        run: impl FnOnce(&mut Self) -> T,
    ) -> Result<T, String> {
        self.take(bytes)?;
        let outcome = run(self);
        self.left += bytes;
        Ok(outcome)
    }

    /// An empty list with room for so many; they are not taken yet.
    ///
    /// # Errors
    /// If they do not fit into the rest, or the system has no such memory.
    pub(super) fn room<T>(&self, count: usize) -> Result<Vec<T>, String> {
        let bytes = count.saturating_mul(size_of::<T>());
        if bytes > self.left {
            return Err(self.too_large());
        }
        let mut list = Vec::new();
        list.try_reserve_exact(count)
            .map_err(|_| format!("takes {bytes} bytes, which the system does not have"))?;
        Ok(list)
    }

    fn too_large(&self) -> String {
        format!("takes more than {} bytes, with what came before it", self.most)
    }
}
